// Looks that take long, beside somebody who does not wait for them.
#include "api/door/live/topics/look_thread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <thread>

namespace slackwater::tests::look_thread_test {
namespace {

using namespace std::chrono_literals;
using live::LooksMade;
using live::LookThread;
using Clock = std::chrono::steady_clock;

/// A look that lasts until it is let go.
struct LongLook {
  std::promise<void> begun, let_go;
  LookThread::Look look() {
    return [this, gone = let_go.get_future().share()] {
      begun.set_value();
      gone.wait();
    };
  }
};

TEST(LookThread, OfThoseThatComeMeanwhileTheNewestIsSeen) {
  LookThread thread(1, {});
  LongLook first;
  std::vector<int> seen;
  thread.hand_in(0, first.look());
  first.begun.get_future().wait();
  const auto before = Clock::now();
  for (int i = 1; i <= 3; ++i) thread.hand_in(0, [&seen, i] { seen.push_back(i); });
  EXPECT_LT(Clock::now() - before, 1s) << "who hands in does not wait";
  EXPECT_EQ(thread.made(0).dropped, 2U);
  std::this_thread::sleep_for(20ms);
  first.let_go.set_value();
  thread.finish();
  EXPECT_EQ(seen, std::vector<int>{3});
  const LooksMade made = thread.made(0);
  EXPECT_EQ(made.moments, 4U);
  EXPECT_EQ(made.looks, 2U);
  EXPECT_EQ(made.dropped, 2U);
  EXPECT_EQ(made.unseen, 0U);
  EXPECT_GE(made.worst_s, 0.02);
  EXPECT_GE(2 * made.mean_s(), made.worst_s) << "of two";
}

TEST(LookThread, SensorsTakeTurnsByWhoWaitsLongest) {
  LookThread thread(3, {});
  LongLook first;
  std::vector<std::size_t> order;
  thread.hand_in(1, first.look());
  first.begun.get_future().wait();
  for (const std::size_t sensor : {2U, 0U, 1U})
    thread.hand_in(sensor, [&order, sensor] { order.push_back(sensor); });
  first.let_go.set_value();
  thread.finish();
  EXPECT_EQ(order, (std::vector<std::size_t>{2, 0, 1}));
  for (const std::size_t sensor : {0U, 1U, 2U}) EXPECT_EQ(thread.made(sensor).dropped, 0U);
}

TEST(LookThread, WhatCannotBeSeenIsCountedAndToldOnce) {
  std::vector<std::string> told;
  LookThread thread(2, [&](std::size_t sensor, const std::string& why) {
    told.push_back(std::to_string(sensor) + ": " + why);
  });
  for (int i = 0; i < 3; ++i) {
    std::promise<void> made;
    thread.hand_in(1, [&] {
      made.set_value();
      throw std::runtime_error("in air");
    });
    made.get_future().wait();
  }
  bool is_seen = false;
  thread.hand_in(1, [&] { is_seen = true; });
  thread.finish();
  EXPECT_TRUE(is_seen) << "it may see again";
  EXPECT_EQ(told, std::vector<std::string>{"1: in air"});
  EXPECT_EQ(thread.made(1).unseen, 3U);
  EXPECT_EQ(thread.made(1).looks, 1U);
  thread.hand_in(0, [] { FAIL() << "it is over"; });
  EXPECT_EQ(thread.made(0).moments, 0U);
}

TEST(LookThread, NoSensorStarvesBehindASlowOne) {
  LookThread thread(2, {});
  const auto look = [] { std::this_thread::sleep_for(20ms); };
  for (int i = 0; i < 120; ++i) {
    thread.hand_in(0, look);
    thread.hand_in(1, look);
    std::this_thread::sleep_for(5ms);
  }
  thread.finish();
  const auto first = thread.made(0).looks, second = thread.made(1).looks;
  EXPECT_GT(first, 3U);
  EXPECT_LE(std::max(first, second) - std::min(first, second), 2U);
}

}  // namespace
}  // namespace slackwater::tests::look_thread_test
