#include "cuda/work_list.cuh"

#include <gtest/gtest.h>

namespace facet {
namespace {

struct Padded {
  std::uint8_t small;
  double large;
};

/// The same values, in memory that held `garbage`.
WorkList list_of(std::uint8_t garbage, const Padded& values) {
  Padded argument;
  std::memset(static_cast<void*>(&argument), garbage, sizeof argument);
  argument.small = values.small, argument.large = values.large;
  static const int kernel = 0;
  WorkList list;
  list.call(&kernel, 2, 3, argument, 7);
  return list;
}

TEST(WorkList, OfEqualWorkHasEqualContentWhateverPadsItsArguments) {
  EXPECT_EQ(list_of(0x55, {1, 2}).content(), list_of(0xAA, {1, 2}).content());
}

TEST(WorkList, KeepsTheArgumentsOfItsCalls) {
  WorkList list = list_of(0, {1, 2.5});
  list.call(nullptr, 1, 1, 8);
  const auto& call = std::get<WorkList::Call>(list.pieces()[0]);
  const auto arguments = list.arguments_of(call);
  EXPECT_EQ(static_cast<const Padded*>(arguments[0])->large, 2.5);
  EXPECT_EQ(*static_cast<const int*>(arguments[1]), 7);
  EXPECT_EQ(*static_cast<const int*>(list.arguments_of(std::get<WorkList::Call>(list.pieces()[1]))[0]), 8);
}

TEST(WorkList, OfOtherWorkHasOtherContent) {
  const int kernels[2]{};
  int memory[2]{};
  std::vector<WorkList> lists(8);
  lists[1].call(&kernels[0], 2, 3, 7);
  lists[2].call(&kernels[1], 2, 3, 7);
  lists[3].call(&kernels[0], 3, 2, 7);
  lists[4].call(&kernels[0], 2, 3, 8);
  lists[5].copy(&memory[0], &memory[1], 4, cudaMemcpyHostToDevice);
  lists[6].copy(&memory[0], &memory[1], 8, cudaMemcpyHostToDevice);
  lists[7].copy(&memory[0], &memory[1], 4, cudaMemcpyDeviceToHost);
  for (std::size_t i = 0; i < lists.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(lists[i].content(), lists[k].content()) << i << ' ' << k;
  lists[4].clear();
  EXPECT_EQ(lists[4].content(), lists[0].content());
}

}  // namespace
}  // namespace facet
