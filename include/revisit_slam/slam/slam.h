// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include <exception>
#include <memory>
#include <variant>

#include "revisit_slam/util/work_queue.h"
#include "revisit_slam/slam/back_end.h"
#include "revisit_slam/slam/map_builder.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/slam/slam_observer.h"

namespace revisit_slam {

/// Maps, loops and graph behind the odometry, wired together without ROS: maps grow in the thread
/// that inserts scans, loops and optimisation run in one background thread. The same scans give the
/// same results, to the last bit, however the threads take turns.
class Slam {
 public:
  /// The observer must outlive this.
  Slam(const SlamConfig& config, SlamObserver& observer);
  ~Slam();

  /// Waits while the background is more than a few local maps behind.
  void insert(const InformedScan& scan);

  /// Closes the open maps, searches and optimises a last time, and waits for the end of it.
  /// @throws what the background thread has thrown.
  void finish();

  /// After finish().
  const BackEnd& backEnd() const { return back_end_; }

 private:
  struct Finish {};
  using Work = std::variant<GraphNode, LocalMapPtr, Finish>;

  void hand(const MapUpdate& update);
  void work(const Work& work);
  void handle(const GraphNode& node) { back_end_.add(node); }
  void handle(const LocalMapPtr& map);
  void handle(Finish) { back_end_.finish(); }

  SlamObserver& observer_;
  BackgroundConfig background_;
  MapBuilder builder_;
  LoopSearch loops_;
  BackEnd back_end_;
  tbb::task_arena arena_;
  bool nice_ = false;
  std::exception_ptr error_;

  WorkQueue<Work> queue_;  // last: its thread uses all of the above
};

}  // namespace revisit_slam
