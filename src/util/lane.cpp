// SPDX-License-Identifier: MIT
#include "revisit_slam/util/lane.h"

#include <utility>

#include "revisit_slam/util/niceness.h"

namespace revisit_slam {

void InlineLane::post(Task task) {
  if (discarding_) return;
  tasks_.push_back(std::move(task));
  if (running_) return;
  struct Running {
    bool& running;
    explicit Running(bool& flag) : running(flag) { running = true; }
    ~Running() { running = false; }
  } running(running_);
  while (!tasks_.empty()) {
    const Task next = std::move(tasks_.front());
    tasks_.pop_front();
    next();
  }
}

ThreadLane::ThreadLane(int niceness, OnError on_error, std::size_t capacity)
    : on_error_(std::move(on_error)),
      queue_(
          capacity, [this](const Task& task) { run(task); }, [] {}) {
  queue_.push([niceness] { setThreadNiceness(niceness); });
}

void ThreadLane::post(Task task) {
  queue_.pushWaiting(std::move(task));
}

void ThreadLane::run(const Task& task) const {
  if (discarding_) return;
  try {
    task();
  } catch (...) {
    on_error_(std::current_exception());
  }
}

}  // namespace revisit_slam
