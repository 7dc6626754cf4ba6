#include "cuda/emulated_device.hpp"

#include "cuda/counted_frame.hpp"
#include "cuda/device_arena.hpp"
#include "support/expect_error.hpp"
#include "support/same_image.hpp"

namespace facet {
namespace {

TEST_F(EmulatedDevice, ItsMemoryIsNotForTheHost) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({3, 2});
  executor.fill(image.view(), 7);
  EXPECT_EQ(executor.on_host(image)(2, 1), 7);
  EXPECT_DEATH(image.view()(2, 1) = 8, "");
}

TEST_F(EmulatedDevice, ItsKernelsAreNotGivenMemoryOfTheHost) {
  EmulatedExecutor executor;
  Image<int> host(Size{3, 2});
  EXPECT_THROW(
      {
        executor.fill(host.view(), 7);
        executor.take_changed();
        executor.changed_flag();
        executor.take_changed();
      },
      std::logic_error);
}

TEST_F(EmulatedDevice, AnImageIsZeroAfterEachChangeOfItsSize) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  for (const Size some : {Size{9, 5}, Size{3, 2}, Size{40, 7}, Size{0, 0}, Size{4, 4}}) {
    image.resize(some);
    const ImageView<const int> host = executor.on_host(image);
    ASSERT_EQ(host.size(), some);
    for (int y = 0; y < some.height; ++y)
      for (int x = 0; x < some.width; ++x) EXPECT_EQ(host(x, y), 0);
    executor.fill(image.view(), 7);
    executor.changed_flag();
    executor.take_changed();  // gives all that to the device, and does not wait for it
  }
}

TEST_F(EmulatedDevice, ACopyForTheHostIsAsNewAsTheImage) {
  EmulatedExecutor executor;
  DeviceImage<std::uint16_t> image;
  image.resize({33, 9});
  for (const std::uint16_t value : std::array<std::uint16_t, 3>{3, 4, 5}) {
    executor.fill(image.view(), value);
    EXPECT_EQ(executor.on_host(image)(32, 8), value);
    EXPECT_EQ(executor.on_host(image)(0, 0), value);
  }
}

TEST_F(EmulatedDevice, WhatIsUploadedMayChangeAtOnceAndComesBackWhole) {
  EmulatedExecutor executor;
  DeviceImage<float> first, second;
  Image<float> host(Size{33, 9}), back(Size{33, 9});
  first.resize(host.size()), second.resize(host.size());  // which waits for the device
  for (DeviceImage<float>* image : {&first, &second}) {
    host.fill(image == &first ? 1.0f : 2.0f);
    executor.upload(std::as_const(host).view(), image->view());
  }
  executor.download(first.view(), back.view());
  EXPECT_EQ(back(32, 8), 1.0f);
  executor.download(second.view(), back.view());
  EXPECT_EQ(back(32, 8), 2.0f);
}

TEST_F(EmulatedDevice, AFrameInWholeUnitsTravelsInHalfTheBytes) {
  EmulatedExecutor executor;
  DeviceImage<float> image;
  image.resize({256, 256});
  const CountedFrame frame(image.size(), 0.0002, [](int x, int y) { return 256 * y + x; });
  Image<float> back(image.size());
  upload_depth(executor, frame.depth_m.view(), frame.counts(), image.view());
  executor.download(image.view(), back.view());
  EXPECT_TRUE(same_image(back, frame.depth_m));
  EXPECT_EQ(emulated_runtime().uploaded, 2u * 65536);
  upload_depth(executor, frame.depth_m.view(), std::nullopt, image.view());
  executor.download(image.view(), back.view());
  EXPECT_TRUE(same_image(back, frame.depth_m));
  EXPECT_EQ(emulated_runtime().uploaded, 6u * 65536);
}

/// Counts down: `value` to 0, one per pass.
struct CountDownOp {
  static constexpr int radius = 0;
  ImageView<int> value;
  int* changed;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (value(x, y) == 0) return;
    --value(x, y);
    raise_flag(changed);
  }
};

TEST_F(EmulatedDevice, AnIteratedStageEndsAfterItsLastChange) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({5, 3});
  for (const int count : {0, 1, 2, 7, 3, 90, 7, 7}) {
    executor.fill(image.view(), count);
    executor.take_changed();
    do {
      executor.for_each_pixel(image.size(), CountDownOp{image.view(), executor.changed_flag()});
    } while (executor.take_changed());
    EXPECT_EQ(executor.on_host(image)(4, 2), 0);
  }
}

TEST_F(EmulatedDevice, IsWaitedForOnceByAStageThatIsAsLongAsTheLastTime) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({5, 3});
  const auto waits_of_countdown = [&] {
    executor.fill(image.view(), 20);
    executor.take_changed();
    emulated_runtime().waits = 0;
    do {
      executor.for_each_pixel(image.size(), CountDownOp{image.view(), executor.changed_flag()});
    } while (executor.take_changed());
    return emulated_runtime().waits;
  };
  EXPECT_GT(waits_of_countdown(), 15);
  for (int again = 0; again < 3; ++again) EXPECT_EQ(waits_of_countdown(), 1);
}

TEST_F(EmulatedDevice, AStageThatIsStoppedEarlyDoesNotEndTheNextOne) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({5, 3});
  for (const int limit : {1, 2, 3, 4, 5}) {
    for (const int most : {limit, 1000}) {
      executor.fill(image.view(), 4);
      executor.take_changed();
      for (int pass = 0; pass < most; ++pass) {
        executor.for_each_pixel(image.size(), CountDownOp{image.view(), executor.changed_flag()});
        if (!executor.take_changed()) break;
      }
      EXPECT_EQ(executor.on_host(image)(4, 2), std::max(0, 4 - most)) << limit;
    }
  }
}

TEST_F(EmulatedDevice, WithoutMemoryAnErrorSaysSo) {
  emulated_runtime().memory_left = 1000;
  EmulatedExecutor executor;
  DeviceImage<float> image;
  expect_error(ErrorKind::not_measured, "CUDA cannot allocate device memory: out of memory", [&] {
    image.resize({640, 480});
  });
}

TEST_F(EmulatedDevice, StagesAreTimedByEventsAndTheTotalByTheClock) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({3, 2});
  double total_ms = 0, stage_ms = 0, other_ms = 0;
  executor.timed(total_ms, [&] {
    executor.timed(stage_ms, [&] {
      for (int i = 0; i < 3; ++i) executor.fill(image.view(), i);
    });
    executor.timed(other_ms, [&] { executor.fill(image.view(), 3); });
    EXPECT_EQ(stage_ms, 0);
  });
  EXPECT_EQ(stage_ms, 3);  // kernels
  EXPECT_EQ(other_ms, 1);
  EXPECT_GT(total_ms, 0);
}

TEST_F(EmulatedDevice, WhatTheHostDoesInAStageCounts) {
  emulated_runtime().eagerness = Eagerness::at_once;
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({3, 2});
  double total_ms = 0, mixed_ms = 0, host_ms = 0;
  executor.timed(total_ms, [&] {
    executor.timed(mixed_ms, [&] {
      executor.fill(image.view(), 1);
      executor.on_host(image);
      emulated_runtime().now_ms += 10;
      executor.fill(image.view(), 2);
      executor.on_host(image);
    });
    executor.timed(host_ms, [] { emulated_runtime().now_ms += 5; });
  });
  EXPECT_EQ(mixed_ms, 12);
  EXPECT_EQ(host_ms, 5);
}

TEST_F(EmulatedDevice, AFrameThatFailedLeavesNothingToTheNext) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({3, 2});
  double total_ms = 0, lost_ms = 0, stage_ms = 0;
  EXPECT_THROW(executor.timed(total_ms,
                              [&] {
                                executor.timed(lost_ms, [&] { executor.fill(image.view(), 1); });
                                throw Error(ErrorKind::data, "a broken frame");
                              }),
               Error);
  executor.timed(total_ms, [&] { executor.timed(stage_ms, [&] { executor.fill(image.view(), 2); }); });
  EXPECT_EQ(lost_ms, 0);
  EXPECT_EQ(stage_ms, 1);
}

TEST_F(EmulatedDevice, WhatAFailedFrameAskedForLastIsNotDone) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({3, 2});
  executor.fill(image.view(), 1);
  EXPECT_EQ(executor.on_host(image)(0, 0), 1);
  double total_ms = 0;
  EXPECT_THROW(executor.timed(total_ms,
                              [&] {
                                executor.fill(image.view(), 2);
                                throw Error(ErrorKind::data, "a broken frame");
                              }),
               Error);
  EXPECT_EQ(executor.on_host(image)(0, 0), 1);
}

}  // namespace
}  // namespace facet
