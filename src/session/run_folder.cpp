// SPDX-License-Identifier: MIT
#include "revisit_slam/session/run_folder.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "revisit_slam/io/parameter_file.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/util/process_usage.h"
#include "revisit_slam/util/quantile.h"

namespace revisit_slam {
namespace {

using nlohmann::json;

/// Makes the folder before the files in it are opened.
std::string made(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error("cannot make the folder '" + path + "': " + error.message());
  return path;
}

json statistics(const std::map<std::string, std::vector<float>>& stage_ms) {
  json all = json::object();
  for (const auto& [stage, ms] : stage_ms)
    all[stage] = {
        {"median", quantile(ms, 0.5)}, {"p99", quantile(ms, 0.99)}, {"max", quantile(ms, 1.0)}};
  return all;
}

}  // namespace

RunFolder::RunFolder(const std::string& path)
    : path_(made(path)),
      odometry_(file("odometry.tum")),
      information_(file("odometry_information.csv")),
      scan_times_(file("scan_times.csv")) {
  if (!information_ || !scan_times_) throw std::runtime_error("cannot write into '" + path + "'");
  information_ << "scan,stamp,source,mean_squared_residual,weak_directions";
  for (const char* matrix : {"information", "covariance"})
    for (int row = 1; row <= 6; ++row)
      for (int column = row; column <= 6; ++column) information_ << "," << matrix << row << column;
  information_ << "\n";
}

void RunFolder::add(const InformedScan& informed, const StageTimes& times) {
  const RegisteredScan& scan = *informed.scan;
  odometry_.write({scan.stamp, scan.T_odom_base});
  if (scan.id.value == 0) distance_.goOnFrom(scan.T_odom_base.translation);
  distance_.go(scan.T_odom_base.translation);
  writeInformation(informed);
  writeTimes(scan, times);
}

void RunFolder::writeInformation(const InformedScan& informed) {
  information_ << informed.scan->id.value << "," << stampText(informed.scan->stamp) << ","
               << toString(informed.source) << "," << informed.estimate.mean_squared_residual << ","
               << informed.estimate.weak_directions.size();
  for (const Matrix6* matrix : {&informed.estimate.information, &informed.covariance_motion})
    for (int row = 0; row < 6; ++row)
      for (int column = row; column < 6; ++column) information_ << "," << (*matrix)(row, column);
  endLine(information_, "odometry_information.csv");
}

void RunFolder::writeTimes(const RegisteredScan& scan, const StageTimes& times) {
  if (stages_.empty()) {
    scan_times_ << "scan,stamp";
    for (const auto& [stage, ms] : times) {
      stages_.emplace_back(stage);
      scan_times_ << "," << stage << "_ms";
    }
    scan_times_ << ",total_ms\n";
  }
  double total = 0.0;
  scan_times_ << scan.id.value << "," << stampText(scan.stamp);
  for (const auto& [stage, ms] : times) {
    scan_times_ << "," << ms;
    stage_ms_[stage].push_back(static_cast<float>(ms));
    total += ms;
  }
  stage_ms_["total"].push_back(static_cast<float>(total));
  scan_times_ << "," << total;
  endLine(scan_times_, "scan_times.csv");
}

void RunFolder::addTimes(const StageTimes& times) {
  for (const auto& [stage, ms] : times) stage_ms_[stage].push_back(static_cast<float>(ms));
}

void RunFolder::endLine(std::ofstream& stream, const std::string& name) const {
  if (!(stream << std::endl)) throw std::runtime_error("cannot write '" + file(name) + "'");
}

void RunFolder::finish(const RunSummary& summary) const {
  const ScanAccount& account = summary.account;
  const double scans = std::max<double>(1.0, static_cast<double>(account.processed));
  const json run = {
      {"version", REVISIT_SLAM_VERSION},
      {"topic", summary.topic},
      {"tracked_frame", summary.tracked_frame},
      {"parameters", toJson(summary.parameters)},
      {"scans",
       {{"received", account.received},
        {"processed", account.processed},
        {"at_rest", account.at_rest},
        {"joined", account.joined},
        {"dropped", account.dropped}}},
      {"points", {{"received", account.points_received}, {"dropped", account.points_dropped}}},
      {"time_source", summary.time_source},
      {"path_length_m", pathLength()},
      {"wall_seconds", summary.wall_seconds},
      {"cpu_seconds", processCpuSeconds()},
      {"cpu_seconds_per_scan", (processCpuSeconds() - summary.reading_cpu_seconds) / scans},
      {"finish_seconds", summary.finish_seconds},
      {"stages_ms", statistics(stage_ms_)},
      {"peak_memory_mb", peakMemoryMegabytes()},
      {"memory_mb_per_km", summary.memory_mb_per_km},
      {"loops", summary.loops},
      {"optimisations", summary.optimisations},
      {"rejected_optimisations", summary.rejected_optimisations},
      {"retroactive_pairs", summary.retroactive_pairs},
      {"revisit_consistency",
       {{"cells", summary.revisited_cells},
        {"rms_mean_m", summary.consistency_mean},
        {"rms_standard_deviation_m", summary.consistency_deviation}}},
      {"threads", summary.threads},
  };
  writeWholeText(file("run.json"), run.dump(2) + "\n");
}

}  // namespace revisit_slam
