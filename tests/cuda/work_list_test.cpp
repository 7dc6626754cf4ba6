#include "cuda/work_list.cuh"

#include <gtest/gtest.h>

#include "stage/temporal_average.hpp"

namespace facet {
namespace {

struct Padded {
  std::uint8_t small;
  double large;
};

/// A list with the same values, in memory that held `garbage`.
template <class T, class SetValues>
WorkList list_of(std::uint8_t garbage, const SetValues& set_values) {
  static const int kernel = 0;
  T argument;
  std::memset(static_cast<void*>(&argument), garbage, sizeof argument);
  set_values(argument);
  WorkList list;
  list.call(&kernel, 2, 3, argument, 7);
  return list;
}

template <class T, class SetValues>
void expect_equal_content(const SetValues& set_values) {
  EXPECT_EQ(list_of<T>(0x55, set_values).content(), list_of<T>(0xAA, set_values).content());
}

void set(Padded& padded) {
  padded.small = 1, padded.large = 2.5;
}

template <class T>
void set(ImageView<T>& view) {
  view.data = nullptr, view.width = 2, view.height = 3, view.stride = 4;
}

TEST(WorkList, OfEqualWorkHasEqualContentWhateverPadsItsArguments) {
  expect_equal_content<Padded>([](Padded& padded) { set(padded); });
  expect_equal_content<TemporalAverageOp>([](TemporalAverageOp& op) {
    op.count = 1, op.mode = TemporalMode::mean;
    op.noise.a_m = op.noise.b_per_m = op.noise.z0_m = op.noise.pixels_per_reading = 1;
    set(op.out);
    for (auto& frame : op.frames) set(frame);
  });
}

TEST(WorkList, KeepsTheArgumentsOfItsCalls) {
  WorkList list = list_of<Padded>(0, [](Padded& padded) { set(padded); });
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
