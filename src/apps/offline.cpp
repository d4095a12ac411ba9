// SPDX-License-Identifier: MIT
// Maps a recorded drive without a ROS master, as fast as the machine allows.
#include <sensor_msgs/PointCloud2.h>
#include <topic_tools/shape_shifter.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "revisit_slam/io/parameter_file.h"
#include "revisit_slam/io/process_usage.h"
#include "revisit_slam/io/progress.h"
#include "revisit_slam/io/run_folder.h"
#include "revisit_slam/pipeline/information_stage.h"
#include "revisit_slam/pipeline/slam.h"
#include "revisit_slam/pipeline/slam_files.h"
#include "revisit_slam/ros/bag_scans.h"
#include "revisit_slam/ros/front_end.h"

namespace revisit_slam {
namespace {

struct Options {
  std::vector<std::string> bags;
  std::string topic, out, parameter_file;
  std::vector<std::string> settings;
  std::size_t max_scans = 0;
  int threads = 0;
  bool quiet = false;
};

SlamConfig readConfig(const Options& options) {
  SlamConfig config;
  const std::vector<Parameter> parameters = parametersOf(config);
  if (!options.parameter_file.empty())
    assign(parameters, readParameterFile(options.parameter_file));
  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
      throw ParameterError("--set " + setting + " is not of the form key=value");
    assign(parameters, {{setting.substr(0, equals), setting.substr(equals + 1)}});
  }
  if (options.threads > 0)
    for (const char* threads : {"odometry/threads", "background/threads", "backend/threads"})
      assign(parameters, {{threads, std::to_string(options.threads)}});
  return config;
}

/// The frame of the topic's first message that has one.
std::string sensorFrame(BagScans& bag) {
  for (const rosbag::MessageInstance& instance : bag.messages()) {
    if (const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>())
      return cloud->header.frame_id;
    // Every message with scans starts with a header; std_msgs/Header reads just that.
    topic_tools::ShapeShifter message;
    std_msgs::Header header;
    std::vector<std::uint8_t> bytes(instance.size());
    ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    instance.write(out);
    ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    ros::serialization::deserialize(in, header);
    return header.frame_id;
  }
  return "";
}

/// A run over the scans of a bag.
class OfflineRun : private SlamObserver {
 public:
  OfflineRun(const Options& options, const SlamConfig& config)
      : config_(config),
        bag_(options.bags, options.topic),
        folder_(options.out),
        front_end_(config),
        information_(config.information),
        files_(options.out, config.mapping, config.occupancy),
        slam_(config, *this),
        total_(options.max_scans > 0 ? std::min(options.max_scans, bag_.size()) : bag_.size()),
        progress_("mapping", "scans", total_, options.quiet) {}

  /// Returns whether everything was read and every file is whole.
  bool run() {
    progress_.say("topic " + bag_.topic() + ", " + std::to_string(total_) + " scans");
    placeSensor();
    const bool all_read = processAll();
    finishMaps();
    progress_.finish();
    writeResults();
    return all_read;
  }

 private:
  void placeSensor() {
    const std::string sensor_frame = sensorFrame(bag_), base_frame = config_.frames.base;
    tracked_frame_ = base_frame;
    if (base_frame.empty() || !bag_.hasTransforms()) {
      tracked_frame_ = sensor_frame;
      progress_.say("poses are those of the sensor, frame '" + sensor_frame + "'" +
                    (base_frame.empty() ? "" : ": the bag has no transforms"));
      return;
    }
    const std::optional<Pose> T_base_sensor = bag_.findExtrinsics(base_frame, sensor_frame);
    if (!T_base_sensor)
      throw BagError("the bag has no transform from '" + sensor_frame + "' to '" + base_frame +
                     "'; set frames/base to a frame that it has, or to nothing for the sensor's own");
    front_end_.setExtrinsics(*T_base_sensor);
  }

  bool processAll() {
    std::size_t done = 0;
    try {
      for (const rosbag::MessageInstance& instance : bag_.messages()) {
        if (done == total_) break;
        process(instance);
        progress_.update(++done);
      }
    } catch (const rosbag::BagException& error) {
      progress_.say("the bag is damaged after scan " + std::to_string(done) + ": " + error.what());
      return false;
    }
    return true;
  }

  void process(const rosbag::MessageInstance& instance) {
    const double cpu_before = threadCpuSeconds();
    const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>();
    const auto other = cloud ? nullptr : instance.instantiate<topic_tools::ShapeShifter>();
    reading_cpu_seconds_ += threadCpuSeconds() - cpu_before;
    FrontEnd::Result result = cloud ? front_end_.process(*cloud) : front_end_.process(*other);
    sayTimeSource();
    if (result.scan) {
      finishScan(std::move(*result.scan), std::move(result.times));
    } else {
      progress_.say("scan at " + std::to_string(instance.getTime().toSec()) + " s dropped: " +
                    result.rejection);
    }
  }

  void finishScan(RegisteredScan&& scan, StageTimes times) {
    StageClock clock;
    const InformedScan informed =
        information_.inform(std::make_shared<const RegisteredScan>(std::move(scan)));
    clock.stage("information");
    if (config_.mapping.enabled) slam_.insert(informed);
    clock.stage("maps");
    for (const auto& time : clock.times()) times.push_back(time);
    folder_.add(informed, times);
  }

  void finishMaps() {
    if (!config_.mapping.enabled) return;
    const Clock::time_point last_scan = Clock::now();
    slam_.finish();
    finish_seconds_ = std::chrono::duration<double>(Clock::now() - last_scan).count();
  }

  void onMaps(const MapUpdate& update) override {
    files_.add(update);
    if (getenv("DBG")) fprintf(stderr, "submap %u scans %zu points %zu detail %zu local %zu rss %.1f path %.0f\n", update.submap->id.value, update.submap->stamps.size(), update.submap->points.size(), update.detail_submap.size(), update.local_map?update.local_map->points.size():0, memoryMegabytes(), folder_.pathLength()); // DBG
    if (!update.local_map) return;
    if (first_memory_mb_ == 0.0) {
      first_memory_mb_ = memoryMegabytes();
      first_memory_path_ = folder_.pathLength();
    }
    last_memory_mb_ = memoryMegabytes();
    last_memory_path_ = folder_.pathLength();
  }

  void onLoopSearch(const LoopSearchResult& result) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    background_times_.push_back(result.times);
    const std::size_t accepted = result.accepted().size();
    if (getenv("DBG")) { std::string t="map "+std::to_string(result.map->id.value)+" feats "+std::to_string(result.view?result.view->features.size():0)+":"; for (auto& c: result.candidates) t+=" "+std::to_string(c.target.value)+"("+std::to_string(c.inliers)+"/"+std::to_string(c.matches)+")"; for(auto&p:result.proposals) t+=std::string(" ")+toString(p.outcome)+" f"+std::to_string(p.registration.fitness)+" c"+std::to_string(p.registration.coherence)+" m"+std::to_string(p.moved_translation)+" r"+std::to_string(p.moved_rotation)+";"; progress_.say(t);} // DBG
    if (accepted > 0)
      progress_.say("local map " + std::to_string(result.map->id.value) + " shows the place of " +
                    std::to_string(result.match->target.value) + ": " + std::to_string(accepted) +
                    " loop constraints");
  }

  void onRetroactive(const std::vector<LoopProposal>& proposals) override { // DBG
    if (getenv("DBG")) { std::string t="retro:"; for(auto&p:proposals) t+=" "+std::to_string(p.loop.source_map.value)+">"+std::to_string(p.loop.target_map.value)+" "+toString(p.outcome)+" f"+std::to_string(p.registration.fitness)+" c"+std::to_string(p.registration.coherence)+" m"+std::to_string(p.moved_translation)+" r"+std::to_string(p.moved_rotation)+" H"+std::to_string(p.hausdorff)+";"; progress_.say(t);} // DBG
  } // DBG
  void onCorrection(const MapCorrectionPtr& correction) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    background_times_.push_back({{"optimisation", 1e3 * correction->seconds}});
  }

  /// Growth between the first and the last local map, where these are far enough from each other.
  double memoryPerKilometre() const {
    const double kilometres = (last_memory_path_ - first_memory_path_) / 1000.0;
    return kilometres > 0.2 ? (last_memory_mb_ - first_memory_mb_) / kilometres : 0.0;
  }

  void sayTimeSource() {
    if (front_end_.timeSource() == said_time_source_) return;
    said_time_source_ = front_end_.timeSource();
    progress_.say(said_time_source_);
  }

  void writeResults() {
    for (const StageTimes& times : background_times_) folder_.addTimes(times);
    RunSummary summary;
    summary.parameters = parametersOf(config_);
    summary.account = front_end_.account();
    summary.topic = bag_.topic();
    summary.tracked_frame = tracked_frame_;
    summary.time_source = front_end_.timeSource();
    summary.wall_seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    summary.reading_cpu_seconds = reading_cpu_seconds_;
    summary.finish_seconds = finish_seconds_;
    summary.memory_mb_per_km = memoryPerKilometre();
    const BackEnd& back_end = slam_.backEnd();
    for (const LoopEdge& edge : back_end.graph().loops())
      ++summary.loops[std::string(toString(edge.loop.origin)) + " " + toString(edge.state)];
    summary.optimisations = back_end.count().optimisations;
    summary.rejected_optimisations = back_end.count().rejected_optimisations;
    summary.retroactive_pairs = back_end.count().retroactive_pairs;
    summary.threads = config_.odometry.threads;
    folder_.finish(summary);
    if (summary.account.processed == 0)
      throw BagError("not one of " + std::to_string(summary.account.received) +
                     " scans could be processed");
    if (config_.mapping.enabled) files_.write(back_end);
  }

  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  SlamConfig config_;
  BagScans bag_;
  RunFolder folder_;
  FrontEnd front_end_;
  InformationStage information_;
  SlamFiles files_;
  Slam slam_;
  std::size_t total_;
  Progress progress_;
  std::string tracked_frame_, said_time_source_;
  double reading_cpu_seconds_ = 0.0, finish_seconds_ = 0.0;
  double first_memory_mb_ = 0.0, first_memory_path_ = 0.0;
  double last_memory_mb_ = 0.0, last_memory_path_ = 0.0;

  std::mutex mutex_;  // guards the next one
  std::vector<StageTimes> background_times_;
};

Options parseOptions(CLI::App& app, int argc, char** argv) {
  Options options;
  app.add_option("--bag", options.bags, "bag file; several are read in the order of time")->required();
  app.add_option("--topic", options.topic, "topic of the scans; may be left out when there is one");
  app.add_option("--out", options.out, "folder for the results; made if missing")->required();
  app.add_option("--params", options.parameter_file, "YAML file of parameters");
  app.add_option("--set", options.settings, "one parameter, as group/name=value")->take_all();
  app.add_option("--threads", options.threads, "threads; results do not depend on it")
      ->check(CLI::Range(1, 64));
  app.add_option("--max-scans", options.max_scans, "stop after so many scans");
  app.add_flag("--quiet", options.quiet, "no progress, only errors");
  app.parse(argc, argv);
  return options;
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  CLI::App app{"Maps a recorded drive; the results are files in a folder"};
  try {
    const revisit_slam::Options options = revisit_slam::parseOptions(app, argc, argv);
    return revisit_slam::OfflineRun(options, revisit_slam::readConfig(options)).run() ? 0 : 1;
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << "offline: " << error.what() << "\n";
    return 1;
  }
}
