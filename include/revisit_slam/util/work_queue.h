// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

namespace revisit_slam {

/// Work items handled in order by a thread of their own. Bounded: when full, the oldest item makes
/// room and `on_drop` hears of it, so that nothing is lost silently.
template <typename Item>
class WorkQueue {
 public:
  WorkQueue(std::size_t capacity, std::function<void(Item)> work, std::function<void()> on_drop)
      : capacity_(capacity),
        work_(std::move(work)),
        on_drop_(std::move(on_drop)),
        thread_([this] { run(); }) {}

  ~WorkQueue() { stop(); }

  /// Returns when the work at hand has ended; what waits is left.
  void stop() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopping_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
  }

  WorkQueue(const WorkQueue&) = delete;
  WorkQueue& operator=(const WorkQueue&) = delete;

  void push(Item item) {
    bool dropped = false;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (items_.size() == capacity_) {
        items_.pop_front();
        dropped = true;
      }
      items_.push_back(std::move(item));
    }
    changed_.notify_all();
    if (dropped) on_drop_();
  }

  /// Waits for room instead, unless the work itself pushes; returns without pushing when the queue
  /// is stopped.
  void pushWaiting(Item item) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (std::this_thread::get_id() != thread_.get_id())
      changed_.wait(lock, [this] { return stopping_ || items_.size() < capacity_; });
    if (stopping_) return;
    items_.push_back(std::move(item));
    lock.unlock();
    changed_.notify_all();
  }

  /// Returns when everything pushed so far is done, or the queue is stopped.
  void drain() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return stopping_ || (items_.empty() && !working_); });
  }

  std::size_t waiting() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return items_.size();
  }

  /// That work has taken so far. Seconds.
  double busySeconds() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::chrono::duration<double>(working_ ? busy_ + (Clock::now() - since_) : busy_)
        .count();
  }

  /// The item that waits and came last.
  std::optional<Item> newest() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return items_.empty() ? std::nullopt : std::optional<Item>(items_.back());
  }

  /// For work that waits for something: true as soon as the queue is to stop.
  bool stopping() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return stopping_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void run() {
    for (std::unique_lock<std::mutex> lock(mutex_);;) {
      changed_.wait(lock, [this] { return stopping_ || !items_.empty(); });
      if (stopping_) return;
      Item item = std::move(items_.front());
      items_.pop_front();
      working_ = true;
      since_ = Clock::now();
      lock.unlock();
      changed_.notify_all();
      work_(std::move(item));
      lock.lock();
      working_ = false;
      busy_ += Clock::now() - since_;
      if (items_.empty()) changed_.notify_all();
    }
  }

  const std::size_t capacity_;
  const std::function<void(Item)> work_;
  const std::function<void()> on_drop_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Item> items_;   // guarded by mutex_
  bool working_ = false;     // guarded by mutex_
  bool stopping_ = false;    // guarded by mutex_
  Clock::time_point since_;  // it works, guarded by mutex_
  Clock::duration busy_{0};  // before, guarded by mutex_

  std::thread thread_;  // last: it uses all of the above
};

}  // namespace revisit_slam
