// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <limits>

#include "revisit_slam/util/work_queue.h"

namespace revisit_slam {

/// Tasks done one after the other, in the order in which they were posted.
class Lane {
 public:
  using Task = std::function<void()>;

  virtual ~Lane() = default;

  virtual void post(Task task) = 0;
  /// Returns when everything that was posted, and what that posted in turn, is done.
  virtual void drain() = 0;
  /// Leaves what waits undone, and whatever is posted from here on.
  virtual void discard() = 0;
  virtual std::size_t waiting() const = 0;
};

/// Does a task at once, in the thread that posts it; what a task posts follows after it. For one
/// thread.
class InlineLane final : public Lane {
 public:
  void post(Task task) override;
  void drain() override {}
  void discard() override {
    discarding_ = true;
    tasks_.clear();
  }
  std::size_t waiting() const override { return tasks_.size(); }

 private:
  std::deque<Task> tasks_;
  bool running_ = false, discarding_ = false;
};

/// Does tasks in a thread of its own. What a task throws ends with it: `on_error` gets it, and the
/// next task follows.
class ThreadLane final : public Lane {
 public:
  using OnError = std::function<void(std::exception_ptr)>;
  static constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

  /// `niceness` of the thread, 0 to 19. Others that post while `capacity` tasks wait wait too.
  ThreadLane(int niceness, OnError on_error, std::size_t capacity = kUnlimited);
  ~ThreadLane() override { stop(); }

  void post(Task task) override;
  void drain() override { queue_.drain(); }
  void discard() override { discarding_ = true; }
  std::size_t waiting() const override { return queue_.waiting(); }
  double busySeconds() const { return queue_.busySeconds(); }

  /// Ends after the task at hand; what waits is left.
  void stop() { queue_.stop(); }

 private:
  void run(const Task& task) const;

  const OnError on_error_;
  std::atomic<bool> discarding_{false};
  WorkQueue<Task> queue_;  // last: its thread uses the above
};

}  // namespace revisit_slam
