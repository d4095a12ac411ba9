// SPDX-License-Identifier: MIT
// What each part brings on a drive with known truth: all combinations of the paper's parts and
// ours.
#include <sensor_msgs/PointCloud2.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "benchmark_ablation/ablation_cells.h"
#include "revisit_slam/evaluation/consistency_builder.h"
#include "revisit_slam/evaluation/evaluation.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/ros/input/scan_reader.h"
#include "revisit_slam/session/session_graph.h"
#include "revisit_slam/slam/loop_replay.h"
#include "revisit_slam/slam/slam.h"
#include "revisit_slam/util/progress.h"

namespace revisit_slam {
namespace {

using nlohmann::json;

/// Cells of revisits as large as two submaps: these are what is compared.
constexpr double kConsistencyCell = 50.0;

struct Options {
  std::string bag, topic, truth, out, base = "base_link";
  std::size_t max_scans = 0;
  int threads = 1;
  bool with_scales = false, quiet = false;
};

/// Keeps what loops and graph are given, and the points of submaps as files have them.
class MappingRecorder : public SlamObserver {
 public:
  void onScan(const InformedScan& informed, const StageTimes&) override {
    drive.nodes.push_back(nodeOf(informed));
  }
  void onMaps(const MapUpdate& update) override {
    submaps.push_back(update.submap);
    details.push_back(update.detail_submap);
    if (update.local_map) drive.maps.push_back(update.local_map);
  }

  MappedDrive drive;
  std::vector<SubmapPtr> submaps;
  std::vector<Points> details;
};

void mapDrive(const Options& options, const SlamConfig& config, MappingRecorder& recorder) {
  BagScans bag({options.bag}, options.topic);
  ScanReader reader(config.input);
  InlineExecutor executor;
  Slam slam(config, recorder, executor);
  std::optional<Pose> T_base_sensor;
  if (options.base.empty() || !bag.hasTransforms()) T_base_sensor = Pose::identity();
  const std::size_t total =
      options.max_scans > 0 ? std::min(options.max_scans, bag.size()) : bag.size();
  Progress progress("mapping", "scans", total, options.quiet);
  std::size_t done = 0;
  for (const rosbag::MessageInstance& instance : bag.messages()) {
    if (done == total) break;
    ScanReading reading = readScan(instance, reader);
    if (!T_base_sensor) T_base_sensor = bag.findExtrinsics(options.base, reading.frame_id);
    if (!T_base_sensor) throw BagError("the bag does not say where the sensor is");
    if (reading.scan) reading.scan->T_base_sensor = *T_base_sensor;
    slam.insert(std::move(reading));
    progress.update(++done);
  }
  slam.finish();
  progress.finish();
  if (recorder.drive.nodes.empty()) throw BagError("no scan of the bag could be processed");
}

MapConsistency consistencyOf(const SlamGraph& graph, const MappingRecorder& mapped,
                             const Trajectory& truth) {
  ConsistencyConfig config;
  config.cell_size = kConsistencyCell;
  ConsistencyBuilder builder(findRevisits(truth, config), config);
  for (std::size_t i = 0; i < mapped.submaps.size(); ++i) {
    const Submap& submap = *mapped.submaps[i];
    if (builder.wants(submap.stamps.front()))
      builder.insert(submap.stamps.front(), mapped.details[i], graph.pose(submap.first_scan));
  }
  return builder.finish();
}

json number(double value) {
  return std::isfinite(value) ? json(value) : json();
}

/// Residuals sqrt(e' information e) of the loops in force: the unit of the kernel's scale.
json loopsOf(const SlamGraph& graph) {
  std::vector<double> before, after, weights;
  int rejected = 0;
  for (const LoopEdge& edge : graph.loops()) {
    rejected += edge.state == LoopState::rejected;
    if (edge.state != LoopState::active) continue;
    before.push_back(std::sqrt(edge.chi2_before));
    after.push_back(std::sqrt(edge.chi2_after));
    weights.push_back(edge.weight);
  }
  const auto quantile = [](std::vector<double> values, double share) {
    if (values.empty()) return json();
    std::sort(values.begin(), values.end());
    return json(values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))]);
  };
  return {
      {"active", after.size()},
      {"rejected", rejected},
      {"residual_before", {quantile(before, 0.5), quantile(before, 0.9), quantile(before, 1.0)}},
      {"residual_after", {quantile(after, 0.5), quantile(after, 0.9), quantile(after, 1.0)}},
      {"smallest_weight", quantile(weights, 0.0)}};
}

json judge(const AblationCell& cell, const SlamGraph& graph, const MappingRecorder& mapped,
           const PoseInterpolator& truth) {
  const TrajectoryEvaluation errors =
      evaluateTrajectory(PoseInterpolator(trajectoryOf(graphOf(graph))), truth);
  const MapConsistency maps = consistencyOf(graph, mapped, truth.poses());
  return {{"odometry", cell.odometry},
          {"information", cell.information},
          {"loops", cell.loops},
          {"retroactive", cell.retroactive},
          {"kernel", cell.kernel},
          {"kernel_scale", cell.kernel_scale},
          {"ate_m", errors.absolute.rmse},
          {"max_m", errors.absolute.max},
          {"rpe_percent", number(errors.relative.translation_percent)},
          {"consistency_m", number(maps.of_pairs.mean)},
          {"constraints", loopsOf(graph)}};
}

void run(const Options& options) {
  const PoseInterpolator truth(readTum(options.truth));
  json cells = json::array(), scales = json::array();
  for (const char* odometry : {"ours", "paper"}) {
    MappingRecorder mapped;
    SlamConfig front_end = frontEndOf(odometry);
    front_end.odometry.threads = options.threads;
    mapDrive(options, front_end, mapped);
    const auto judged = [&](AblationCell cell) {
      cell.config.background.threads = cell.config.backend.solver.threads = options.threads;
      const LoopReplay replay(mapped.drive, cell.config);
      return judge(cell, replay.graph(), mapped, truth);
    };
    for (const AblationCell& cell : cellsOf(odometry)) cells.push_back(judged(cell));
    if (!options.with_scales) continue;
    for (const AblationCell& cell : kernelScalesOf(odometry)) scales.push_back(judged(cell));
  }
  writeWholeText(options.out, json({{"cells", cells}, {"kernel_scales", scales}}).dump(1) + "\n");
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  CLI::App app{"All combinations of the paper's parts and ours on a drive with known truth"};
  revisit_slam::Options options;
  app.add_option("--bag", options.bag, "bag file")->required();
  app.add_option("--points,--topic", options.topic,
                 "topic of the scans; may be left out when there is one");
  app.add_option("--base", options.base, "frame of the poses; empty: the sensor's");
  app.add_option("--truth", options.truth, "TUM file of the true poses")->required();
  app.add_option("--out", options.out, "JSON file to write")->required();
  app.add_option("--max-scans", options.max_scans, "stop after so many scans; 0: all");
  app.add_option("--threads", options.threads, "threads; results do not depend on it")
      ->check(CLI::Range(1, 64));
  app.add_flag("--scales", options.with_scales, "also the kernels with other scales");
  app.add_flag("--quiet", options.quiet, "no progress");
  CLI11_PARSE(app, argc, argv);
  try {
    revisit_slam::run(options);
  } catch (const std::exception& error) {
    std::cerr << "benchmark_ablation: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
