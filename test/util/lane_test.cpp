// SPDX-License-Identifier: MIT
#include "revisit_slam/util/lane.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace revisit_slam {
namespace {

TEST(InlineLane, doesTasksAtOnceAndWhatTheyPostAfterThem) {
  InlineLane lane;
  std::string order;
  lane.post([&] {
    lane.post([&] { order += "c"; });
    order += "a";
    lane.post([&] { order += "d"; });
    order += "b";
  });
  EXPECT_EQ(order, "abcd");
  EXPECT_EQ(lane.waiting(), 0u);
}

TEST(InlineLane, goesOnAfterATaskThatThrew) {
  InlineLane lane;
  EXPECT_THROW(lane.post([] { throw std::runtime_error("no"); }), std::runtime_error);
  bool done = false;
  lane.post([&] { done = true; });
  EXPECT_TRUE(done);
}

TEST(ThreadLane, reportsWhatATaskThrowsAndGoesOn) {
  std::string problem;
  ThreadLane lane(0, [&](std::exception_ptr error) {
    try {
      std::rethrow_exception(error);
    } catch (const std::exception& thrown) {
      problem = thrown.what();
    }
  });
  std::vector<int> done;
  lane.post([&] { done.push_back(1); });
  lane.post([] { throw std::runtime_error("disk full"); });
  lane.post([&] { done.push_back(2); });
  lane.drain();
  EXPECT_EQ(problem, "disk full");
  EXPECT_EQ(done, (std::vector<int>{1, 2}));
}

TEST(ThreadLane, tellsHowLongItWasBusy) {
  ThreadLane lane(0, [](std::exception_ptr) { FAIL(); });
  lane.drain();
  const double before = lane.busySeconds();
  for (int i = 0; i < 2; ++i)
    lane.post([] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); });
  lane.drain();
  EXPECT_GE(lane.busySeconds() - before, 0.04);
}

TEST(ThreadLane, aTaskMayPostThoughTheLaneIsFull) {
  constexpr std::size_t capacity = 1;
  ThreadLane lane(
      0, [](std::exception_ptr) { FAIL(); }, capacity);
  int done = 0;
  lane.post([&] {
    for (int i = 0; i < 5; ++i) lane.post([&] { ++done; });
  });
  lane.drain();
  EXPECT_EQ(done, 5);
}

TEST(ThreadLane, othersWaitWhileItIsFull) {
  std::promise<void> release;
  ThreadLane lane(
      0, [](std::exception_ptr) { FAIL(); }, 1);
  const std::shared_future<void> released = release.get_future().share();
  lane.post([released] { released.wait(); });
  std::atomic<bool> posted{false};
  const auto poster = std::async(std::launch::async, [&] {
    for (int i = 0; i < 3; ++i) lane.post([] {});
    posted = true;
  });
  EXPECT_EQ(poster.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  EXPECT_FALSE(posted);
  release.set_value();
  poster.wait();
  EXPECT_TRUE(posted);
}

}  // namespace
}  // namespace revisit_slam
