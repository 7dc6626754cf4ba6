#include "core/launch.hpp"

#include <gtest/gtest.h>

#include "support/awkward_frames.hpp"

namespace facet {
namespace {

struct CountVisitsOp {
  ImageView<int> visits;
  template <class Access>
  void operator()(int x, int y, Access) const {
    ++visits(x, y);
  }
};

TEST(Launch, CoversEveryPixelOnceAndNothingElse) {
  for (const Size size : awkward_sizes) {
    Image<int> visits(size);
    int threads = 0;
    for (int y = 0; y < Launch::blocks_y(size) * Launch::block_height; ++y)
      for (int x = 0; x < Launch::blocks_x(size) * Launch::block_width; ++x) {
        run_pixel_thread(CountVisitsOp{visits.view()}, size, x, y);
        ++threads;
      }
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) EXPECT_EQ(visits(x, y), 1);
    EXPECT_LT(threads, size.area() + Launch::block_height * (size.width + Launch::block_width) +
                           Launch::block_width * size.height + 1)
        << "no more than one block too many on each side";
  }
}

}  // namespace
}  // namespace facet
