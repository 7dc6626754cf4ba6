#include "cpu/executor.hpp"

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <thread>
#include <type_traits>

#include "support/masks.hpp"
#include "support/same_image.hpp"

namespace facet {
namespace {

/// Counts the visits of every pixel, and those with the access for the interior.
struct VisitOp {
  int radius;
  ImageView<int> visits, interior;
  template <class Access>
  void operator()(int x, int y, Access) const {
    ++visits(x, y);
    if (std::is_same_v<Access, InteriorAccess>) ++interior(x, y);
  }
};

TEST(CpuExecutor, VisitsEveryPixelOnceWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 7})
    for (const Size size : awkward_sizes)
      for (const int radius : {0, 1, 16}) {
        CpuExecutor executor(threads);
        Image<int> visits(size), interior(size);
        executor.for_each_pixel(size, VisitOp{radius, visits.view(), interior.view()});
        EXPECT_TRUE(same_image(visits, Image<int>(size, 1))) << threads << " threads, radius " << radius;
      }
}

TEST(CpuExecutor, SkipsBorderTestsExactlyWhereTheWholeNeighbourhoodLiesInside) {
  CpuExecutor executor;
  for (const int radius : {0, 1, 3, 5}) {
    const Size size{33, 9};
    Image<int> visits(size), interior(size);
    executor.for_each_pixel(size, VisitOp{radius, visits.view(), interior.view()});
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 33; ++x) {
        const bool inside = size.contains(x - radius, y - radius) && size.contains(x + radius, y + radius);
        EXPECT_EQ(interior(x, y), inside ? 1 : 0) << x << ", " << y;
      }
  }
}

TEST(CpuExecutor, VisitsExactlyTheSetPixelsOfAMask) {
  for (const int threads : {1, 3})
    for_each_awkward_mask([&](const Mask& mask) {
      CpuExecutor executor(threads);
      Mask set = mask;
      Image<int> visits(mask.size()), interior(mask.size());
      executor.for_each_set(set.view(), VisitOp{0, visits.view(), interior.view()});
      EXPECT_TRUE(same_image(visits, make_image<int>(mask.size(), [&](int x, int y) { return mask(x, y); })));
    });
}

TEST(CpuExecutor, SharesOutEveryIndexOnceAndTellsApartWhatRunsAtTheSameTime) {
  for (const int threads : {1, 2, 5}) {
    CpuExecutor executor(threads);
    std::vector<int> visits(1000);
    std::vector<std::atomic<int>> busy(static_cast<std::size_t>(executor.workers()));
    executor.share_out(1000, [&](int i, int worker) {
      EXPECT_EQ(++busy[static_cast<std::size_t>(worker)], 1);
      ++visits[static_cast<std::size_t>(i)];
      --busy[static_cast<std::size_t>(worker)];
    });
    EXPECT_EQ(visits, std::vector<int>(1000, 1));
  }
}

TEST(CpuExecutor, PartsCoverEverythingOnceAndNoneIsTooSmall) {
  for (const int threads : {1, 3})
    for (const std::size_t count : {0u, 1u, 9u, 20u, 31u, 1000u}) {
      CpuExecutor executor(threads);
      std::vector<int> visits(count);
      executor.for_each_part(count, 10, [&](std::size_t i, std::size_t begin, std::size_t end) {
        EXPECT_LT(i, static_cast<std::size_t>(threads));
        EXPECT_GE(end - begin, std::min<std::size_t>(count, 10));
        for (std::size_t k = begin; k < end; ++k) ++visits[k];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads << " threads";
    }
}

struct ClearOwnPixelOp {
  static constexpr int radius = 0;
  ImageView<std::uint8_t> mask;
  template <class Access>
  void operator()(int x, int y, Access) const {
    mask(x, y) = 0;
  }
};

TEST(CpuExecutor, LetsAnOperationClearItsOwnPixelOfTheMask) {
  CpuExecutor executor(3);
  Mask mask = random_mask({631, 47}, 1, 0.5f);
  executor.for_each_set(mask.view(), ClearOwnPixelOp{mask.view()});
  EXPECT_TRUE(same_image(mask, Mask(mask.size())));
}

TEST(CpuExecutor, SumsExactlyBeyond32Bits) {
  CpuExecutor executor(3);
  const auto value = [](int x, int y) { return std::int64_t{1} << 33 | (x ^ y); };
  std::int64_t expected = 0;
  for (int y = 0; y < 47; ++y)
    for (int x = 0; x < 631; ++x) expected += value(x, y);
  EXPECT_EQ(executor.sum_pixels({631, 47}, value), expected);
  EXPECT_EQ(executor.sum_pixels({}, value), 0);
}

TEST(CpuExecutor, CopiesAndFillsBetweenImagesOfDifferentStride) {
  CpuExecutor executor;
  Image<float> source = random_depth({33, 9}, 3);
  std::vector<float> dense(33 * 9);
  const ImageView<float> dense_view{dense.data(), 33, 9, 33};
  Image<float> target(source.size());
  executor.copy(std::as_const(source).view(), dense_view);
  executor.copy(ImageView<const float>(dense_view), target.view());
  EXPECT_TRUE(same_image(target, source));
  executor.fill(dense_view, 2.0f);
  EXPECT_EQ(dense, std::vector<float>(33 * 9, 2.0f));
  target.fill(0);
  executor.upload(std::as_const(source).view(), target.view());
  EXPECT_TRUE(same_image(target, source));
  executor.download(target.view(), dense_view);
  EXPECT_EQ(dense_view(32, 8), source(32, 8));
  EXPECT_EQ(executor.on_host(target).data, target.row(0));
}

TEST(CpuExecutor, TakesDownTheFlagItReports) {
  CpuExecutor executor;
  EXPECT_FALSE(executor.take_changed());
  raise_flag(executor.changed_flag());
  EXPECT_TRUE(executor.take_changed());
  EXPECT_FALSE(executor.take_changed());
}

TEST(CpuExecutor, AddsTheWallTimeOfTheWork) {
  CpuExecutor executor;
  double elapsed_ms = 100;
  executor.timed(elapsed_ms, [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); });
  EXPECT_GE(elapsed_ms, 105);
  EXPECT_LT(elapsed_ms, 1100);
}

}  // namespace
}  // namespace facet
