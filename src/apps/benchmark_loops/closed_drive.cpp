// SPDX-License-Identifier: MIT
#include "closed_drive.h"

#include <sensor_msgs/PointCloud2.h>

#include <stdexcept>
#include <utility>

#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/ros/input/scan_reader.h"
#include "revisit_slam/session/session_graph.h"
#include "revisit_slam/slam/slam.h"
#include "revisit_slam/util/process_usage.h"
#include "revisit_slam/util/progress.h"

namespace revisit_slam {
namespace {

Pose extrinsics(BagScans& bag, const std::string& base_frame) {
  if (const auto T_base_sensor = bag.findExtrinsics(base_frame, bag.sensorFrame()))
    return *T_base_sensor;
  throw BagError("the bag does not say where the sensor is on '" + base_frame + "'");
}

double timeOf(const StageTimes& times, const std::string& stage) {
  for (const auto& [name, ms] : times)
    if (name == stage) return ms;
  return 0.0;
}

/// Keeps what each local map's closure came up with.
class ClosureRecorder : public SlamObserver {
 public:
  void onMaps(const MapUpdate& update) override {
    if (update.local_map) cpu_before_ = processCpuSeconds();
  }

  /// Each map is searched by appearance and then retroactively; what follows after the last map is
  /// the search at the end.
  void onLoopSearch(const LoopSearchResult& search) override {
    if (search.origin == LoopOrigin::appearance) {
      MapClosure& closure = maps_.emplace_back();
      closure.search = search;
      closure.recognition_ms = timeOf(search.times, "recognition");
      closure.registration_ms = timeOf(search.times, "registration");
      searches_ = 1;
    } else if (++searches_ == 2) {
      maps_.back().retroactive = search.proposals;
      maps_.back().retroactive_ms = timeOf(search.times, "retroactive");
    } else {
      at_the_end_.insert(at_the_end_.end(), search.proposals.begin(), search.proposals.end());
    }
    noteCpu();
  }

  void onCorrection(const MapCorrectionPtr& correction) override {
    if (searches_ > 2) return;
    maps_.back().optimisation_ms += 1e3 * correction->seconds;
    noteCpu();
  }

  ClosedDrive take(const GraphSession& session) {
    Trajectory odometry;
    for (const GraphNode& node : session.graph().nodes())
      odometry.push_back({node.stamp, node.T_odom_base});
    return {std::move(maps_), std::move(at_the_end_), session.graph().loops(), std::move(odometry),
            trajectoryOf(graphOf(session.graph()))};
  }

 private:
  void noteCpu() {
    if (searches_ > 2) return;
    MapClosure& closure = maps_.back();
    closure.cpu_ms = 1e3 * (processCpuSeconds() - cpu_before_) - closure.optimisation_ms;
  }

  std::vector<MapClosure> maps_;
  std::vector<LoopProposal> at_the_end_;
  double cpu_before_ = 0.0;
  int searches_ = 0;  // since the newest map was closed
};

Pose poseAt(const PoseInterpolator& truth, Stamp stamp) {
  const PoseAnswer answer = truth.at(stamp);
  if (!answer) throw std::runtime_error("the truth does not cover the scan at " + stampText(stamp));
  return answer.T_world_base;
}

void append(Stretch& stretch, const Submap& submap, const Pose& T_map_submap,
            const PoseInterpolator& truth) {
  for (std::size_t i = 0; i < submap.stamps.size(); ++i) {
    stretch.T_map_scan.push_back(T_map_submap * submap.T_submap_scan[i]);
    stretch.T_world_scan.push_back(poseAt(truth, submap.stamps[i]));
  }
}

}  // namespace

ClosedDrive closeLoops(const std::string& path, const std::string& topic, const SlamConfig& config,
                       bool quiet) {
  BagScans bag({path}, topic);
  ScanReader reader(config.input, extrinsics(bag, config.frames.base));
  ClosureRecorder recorder;
  InlineExecutor executor;
  Slam slam(config, recorder, executor);
  Progress progress("mapping", "scans", bag.size(), quiet);
  std::size_t done = 0;
  for (const rosbag::MessageInstance& instance : bag.messages()) {
    slam.insert(readScan(instance, reader));
    progress.update(++done);
  }
  slam.finish();
  progress.finish();
  if (slam.session() == nullptr) throw BagError("no scan of the bag could be processed");
  return recorder.take(*slam.session());
}

Stretch stretchOf(const Submap& submap, const PoseInterpolator& truth) {
  Stretch stretch;
  append(stretch, submap, Pose::identity(), truth);
  return stretch;
}

Stretch stretchOf(const LocalMap& map, const PoseInterpolator& truth) {
  Stretch stretch;
  for (const SubmapPtr& submap : map.submaps)
    append(stretch, *submap, map.T_odom_local().inverse() * submap->T_odom_submap, truth);
  return stretch;
}

}  // namespace revisit_slam
