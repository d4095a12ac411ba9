// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <memory>
#include <mutex>

#include "revisit_slam/slam/background_config.h"
#include "revisit_slam/util/lane.h"

namespace revisit_slam {

/// Where loops and graph are worked on.
class Executor {
 public:
  virtual ~Executor() = default;

  virtual Lane& background() = 0;
  /// Waits until the background has nothing left to do. @throws what it has thrown first.
  virtual void finish() = 0;
};

/// All in the thread that inserts scans: for tests and benchmarks.
class InlineExecutor final : public Executor {
 public:
  Lane& background() override { return lane_; }
  void finish() override {}

 private:
  InlineLane lane_;
};

/// Loops and graph in a thread that stands back behind the one that inserts scans, which waits
/// where the background is far behind.
class StagedExecutor final : public Executor {
 public:
  explicit StagedExecutor(const BackgroundConfig& config);

  Lane& background() override { return lane_; }
  void finish() override;

 private:
  std::mutex mutex_;  // guards the next one
  std::exception_ptr error_;
  ThreadLane lane_;  // last: its thread uses the above
};

}  // namespace revisit_slam
