#include "stream/turnstile.hpp"

#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace facet {
namespace {

TEST(Turnstile, ThreadsPassInTheOrderOfTheirTickets) {
  Turnstile turnstile;
  std::vector<std::uint64_t> passed;
  {
    std::vector<std::jthread> threads;
    for (std::uint64_t ticket = 20; ticket-- > 0;)
      threads.emplace_back([&, ticket] {
        ASSERT_TRUE(turnstile.wait_turn(ticket));
        passed.push_back(ticket);  // no lock: one thread at a time is what it promises
        turnstile.pass();
      });
  }
  ASSERT_EQ(passed.size(), 20u);
  for (std::uint64_t i = 0; i < 20; ++i) EXPECT_EQ(passed[i], i);
}

TEST(Turnstile, StoppingSendsAwayWhoeverWaits) {
  Turnstile turnstile;
  bool passed = true;
  {
    const std::jthread thread([&] { passed = turnstile.wait_turn(1); });
    turnstile.stop();
  }
  EXPECT_FALSE(passed);
}

}  // namespace
}  // namespace facet
