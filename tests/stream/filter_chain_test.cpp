#include "stream/filter_chain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "support/expect_error.hpp"

namespace facet {
namespace {

/// Takes a time that differs from frame to frame.
void dawdle(Passage& passage) {
  std::minstd_rand random(static_cast<unsigned>(passage.number + 1));
  std::this_thread::sleep_for(std::chrono::microseconds(random() % 300));
}

Passage numbered(std::size_t number) {
  Passage passage;
  passage.number = number;
  return passage;
}

/// Offers frames until that many are accepted or the chain has stopped, then closes it.
std::jthread offer(FilterChain& chain, std::size_t count) {
  return std::jthread([&chain, count] {
    for (std::size_t i = 0; i < count && chain.offer(numbered(i)); ++i) {
    }
    chain.close();
  });
}

TEST(FilterChain, FramesLeaveInTheOrderInWhichTheyCameWhateverTheThreadsDo) {
  constexpr std::size_t count = 300;
  FilterChain chain({{"a", 3, dawdle}, {"b", 1, dawdle}, {"c", 4, dawdle}}, 2);
  const std::jthread producer = offer(chain, count);
  std::size_t next = 0;
  while (const auto passage = chain.take()) EXPECT_EQ(passage->number, next++);
  EXPECT_EQ(next, count);
}

TEST(FilterChain, EveryFrameHasItsTimesAndPassesEveryFilterOnce) {
  std::atomic<int> first = 0, second = 0;
  FilterChain chain(
      {{"a", 2, [&](Passage& p) { dawdle(p), ++first; }}, {"b", 2, [&](Passage&) { ++second; }}}, 1);
  const std::jthread producer = offer(chain, 50);
  int left = 0;
  while (const auto passage = chain.take()) {
    ++left;
    EXPECT_GT(passage->filters[0].work_ms, 0);
    EXPECT_GE(passage->filters[0].cpu_ms, 0);
    EXPECT_GT(passage->entered.time_since_epoch().count(), 0);
  }
  EXPECT_THAT((std::array{first.load(), second.load(), left}), ::testing::Each(50));
  const auto queues = chain.queue_statistics();
  ASSERT_EQ(queues.size(), 3u);
  for (const QueueStatistics& queue : queues) {
    EXPECT_EQ(queue.taken_in, 50u);
    EXPECT_EQ(queue.max_depth, 1u);
  }
}

TEST(FilterChain, AFilterThatThrowsStopsEverythingWithItsError) {
  for (const std::size_t broken : {0, 1, 2}) {
    std::vector<Filter> filters{{"a", 2, dawdle}, {"b", 3, dawdle}, {"c", 1, dawdle}};
    filters[broken].work = [](Passage& passage) {
      if (passage.number == 7) throw Error(ErrorKind::data, "frame 7 is broken");
    };
    FilterChain chain(std::move(filters), 1);
    const std::jthread producer = offer(chain, 1000000);  // waits for room all the time
    expect_error(ErrorKind::data, "frame 7 is broken", [&] {
      while (const auto passage = chain.take()) EXPECT_LT(passage->number, 7u);
    });
  }
}

TEST(FilterChain, ASinkThatGoesAwayLeavesNobodyWaiting) {
  std::jthread producer;
  FilterChain chain({{"a", 2, dawdle}, {"b", 2, dawdle}}, 1);
  producer = offer(chain, 1000000);
  EXPECT_TRUE(chain.take());
  chain.fail(std::make_exception_ptr(Error(ErrorKind::internal, "enough")));
  producer.join();
  expect_error(ErrorKind::internal, "enough", [&] { chain.take(); });
}

TEST(FilterChain, WhatIsDroppedIsCountedAndTheRestStaysInOrder) {
  constexpr std::size_t count = 2000;
  FilterChain chain({{"a", 1, dawdle}, {"b", 2, dawdle}}, 2);
  const std::jthread producer([&] {
    for (std::size_t i = 0; i < count; ++i) chain.offer_over_oldest(numbered(i));
    chain.close();
  });
  std::size_t left = 0, last = 0;
  while (const auto passage = chain.take()) {
    EXPECT_TRUE(left == 0 || passage->number > last) << passage->number << " after " << last;
    last = passage->number;
    ++left;
  }
  const QueueStatistics first = chain.queue_statistics().front();
  EXPECT_GT(first.dropped, 0u);
  EXPECT_EQ(left + first.dropped, count);
  EXPECT_EQ(last, count - 1) << "the newest frame is never given up";
}

}  // namespace
}  // namespace facet
