// SPDX-License-Identifier: MIT
#include "revisit_slam/util/work_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <vector>

namespace revisit_slam {
namespace {

/// Work that stands still until released.
struct Gate {
  std::promise<void> started, released;
  std::shared_future<void> release = released.get_future().share();
};

TEST(WorkQueue, handlesItemsInTheOrderOfTheirComing) {
  std::vector<int> handled;
  std::promise<void> done;
  const auto work = [&](int item) {
    handled.push_back(item);
    if (item == 99) done.set_value();
  };
  WorkQueue<int> queue(100, work, [] { FAIL() << "there was room"; });
  for (int i = 0; i < 100; ++i) queue.push(i);
  done.get_future().wait();
  for (int i = 0; i < 100; ++i) EXPECT_EQ(handled[static_cast<std::size_t>(i)], i);
}

TEST(WorkQueue, fullQueueDropsTheOldestAndSaysSo) {
  Gate gate;
  std::vector<int> handled;
  std::promise<void> done;
  int dropped = 0;
  const auto work = [&](int item) {
    if (item == 0) gate.started.set_value();
    gate.release.wait();
    handled.push_back(item);
    if (item == 5) done.set_value();
  };
  WorkQueue<int> queue(2, work, [&] { ++dropped; });
  queue.push(0);
  gate.started.get_future().wait();
  for (int i = 1; i <= 5; ++i) queue.push(i);
  EXPECT_EQ(queue.waiting(), 2u);
  EXPECT_EQ(dropped, 3);
  gate.released.set_value();
  done.get_future().wait();
  EXPECT_EQ(handled, (std::vector<int>{0, 4, 5}));
}

TEST(WorkQueue, pushWaitingLosesNothingAndDrainReturnsWhenAllIsDone) {
  std::vector<int> handled;
  WorkQueue<int> queue(
      3, [&](int item) { handled.push_back(item); }, [] { FAIL() << "waits for room instead"; });
  for (int i = 0; i < 1000; ++i) queue.pushWaiting(i);
  queue.drain();
  ASSERT_EQ(handled.size(), 1000u);
  EXPECT_EQ(handled.back(), 999);
}

TEST(WorkQueue, stoppingEndsTheWaitForRoom) {
  Gate gate;
  const auto work = [&](int) {
    gate.started.set_value();
    gate.release.wait();
  };
  WorkQueue<int> queue(1, work, [] {});
  queue.push(0);
  gate.started.get_future().wait();
  queue.push(1);
  auto pusher = std::async(std::launch::async, [&] { queue.pushWaiting(2); });
  auto stopper = std::async(std::launch::async, [&] { queue.stop(); });
  pusher.wait();
  gate.released.set_value();
}

TEST(WorkQueue, workThatWaitsHearsOfTheEnd) {
  std::promise<void> started;
  std::atomic<bool> heard{false};
  std::atomic<WorkQueue<int>*> self{nullptr};
  {
    const auto work = [&](int) {
      started.set_value();
      while (!self.load()->stopping()) std::this_thread::yield();
      heard = true;
    };
    WorkQueue<int> queue(1, work, [] {});
    self = &queue;
    queue.push(1);
    started.get_future().wait();
    queue.stop();
    EXPECT_TRUE(heard);
    queue.stop();  // and once more by the destructor
  }
}

}  // namespace
}  // namespace revisit_slam
