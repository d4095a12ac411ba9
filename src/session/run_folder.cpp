// SPDX-License-Identifier: MIT
#include "revisit_slam/session/run_folder.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "revisit_slam/io/parameter_file.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/session/session_writer.h"
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
  requireUnused(path);
  return path;
}

json statistics(const std::map<std::string, std::vector<float>>& stage_ms) {
  json all = json::object();
  for (const auto& [stage, ms] : stage_ms)
    all[stage] = {
        {"median", quantile(ms, 0.5)}, {"p99", quantile(ms, 0.99)}, {"max", quantile(ms, 1.0)}};
  return all;
}

json toJson(const std::map<std::string, PriorAccount>& priors) {
  json all = json::object();
  for (const auto& [sensor, account] : priors) {
    all[sensor] = {
        {"messages", {{"received", account.received}, {"dropped", account.dropped}}},
        {"scans",
         {{"used", account.used}, {"rejected", account.rejected}, {"missing", account.missing}}}};
    if (account.scale) all[sensor]["scale"] = *account.scale;
    if (const auto& bias = account.bias) all[sensor]["bias"] = {bias->x(), bias->y(), bias->z()};
  }
  return all;
}

}  // namespace

RunFolder::RunFolder(const std::string& path)
    : path_(made(path)),
      lock_(std::make_shared<FolderLock>(path)),
      odometry_(file("odometry.tum")),
      information_(file("odometry_information.csv")),
      scan_times_(file("scan_times.csv")) {
  std::string header = "scan,stamp,source,mean_squared_residual,weak_directions";
  for (const char* matrix : {"information", "covariance"})
    for (int row = 1; row <= 6; ++row)
      for (int column = row; column <= 6; ++column)
        header += std::string(",") + matrix + std::to_string(row) + std::to_string(column);
  information_.add(header + ",verdict,explained\n");
}

void RunFolder::add(const InformedScan& informed, const StageTimes& times) {
  const RegisteredScan& scan = *informed.scan;
  std::ostringstream pose;
  writeTumLine(pose, {scan.stamp, scan.T_odom_base});
  odometry_.add(pose.str());
  if (scan.id.value == 0) distance_.goOnFrom(scan.T_odom_base.translation);
  distance_.go(scan.T_odom_base.translation);
  ++verdicts_[informed.verdict];
  writeInformation(informed);
  writeTimes(scan, times);
}

void RunFolder::writeInformation(const InformedScan& informed) {
  std::ostringstream line;
  line << informed.scan->id.value << "," << stampText(informed.scan->stamp) << ","
       << toString(informed.source) << "," << informed.estimate.mean_squared_residual << ","
       << informed.estimate.weak_directions.size();
  for (const Matrix6* matrix : {&informed.estimate.information, &informed.covariance_motion})
    for (int row = 0; row < 6; ++row)
      for (int column = row; column < 6; ++column) line << "," << (*matrix)(row, column);
  line << "," << toString(informed.verdict) << "," << informed.scan->registration.explained << "\n";
  information_.add(line.str());
}

void RunFolder::writeTimes(const RegisteredScan& scan, const StageTimes& times) {
  std::ostringstream line;
  if (stages_.empty()) {
    line << "scan,stamp";
    for (const auto& [stage, ms] : times) {
      stages_.emplace_back(stage);
      line << "," << stage << "_ms";
    }
    line << ",total_ms\n";
  }
  double total = 0.0;
  line << scan.id.value << "," << stampText(scan.stamp);
  for (const auto& [stage, ms] : times) {
    line << "," << ms;
    stage_ms_[stage].push_back(static_cast<float>(ms));
    total += ms;
  }
  stage_ms_["total"].push_back(static_cast<float>(total));
  line << "," << total << "\n";
  scan_times_.add(line.str());
}

void RunFolder::addTimes(const StageTimes& times) {
  for (const auto& [stage, ms] : times) stage_ms_[stage].push_back(static_cast<float>(ms));
}

void LineFile::add(const std::string& line) {
  waiting_ += line;
  try {
    flush();
  } catch (const std::runtime_error&) {
    // It waits: flush() at the end tells.
  }
}

void LineFile::flush() {
  file_.append(waiting_);
  waiting_.clear();
}

void judge(const MapConsistency& consistency, RunSummary& summary) {
  summary.revisited_cells = consistency.cells.size();
  if (consistency.cells.empty()) return;
  summary.consistency_mean = consistency.of_pairs.mean;
  summary.consistency_deviation = consistency.of_pairs.standard_deviation;
}

void writeRunSummary(const std::string& path, const RunSummary& summary,
                     const std::map<std::string, std::vector<float>>& stage_ms) {
  const ScanAccount& account = summary.account;
  const double scans = std::max<double>(1.0, static_cast<double>(account.processed));
  json verdicts = json::object();
  for (const auto& [verdict, count] : summary.verdicts) verdicts[toString(verdict)] = count;
  const json run = {
      {"version", softwareVersion()},
      {"interrupted", summary.interrupted},
      {"topic", summary.topic},
      {"tracked_frame", summary.tracked_frame},
      {"parameters", revisit_slam::toJson(summary.parameters)},
      {"scans",
       {{"received", account.received},
        {"processed", account.processed},
        {"at_rest", account.at_rest},
        {"joined", account.joined},
        {"dropped", account.dropped}}},
      {"poses", verdicts},
      {"priors", toJson(summary.priors)},
      {"points", {{"received", account.points_received}, {"dropped", account.points_dropped}}},
      {"time_source", summary.time_source},
      {"path_length_m", summary.path_length},
      {"wall_seconds", summary.wall_seconds},
      {"cpu_seconds", processCpuSeconds()},
      {"cpu_seconds_per_scan", (processCpuSeconds() - summary.reading_cpu_seconds) / scans},
      {"finish_seconds", summary.finish_seconds},
      {"stages_ms", statistics(stage_ms)},
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
  writeWholeText(path, run.dump(2) + "\n");
}

void RunFolder::finish(RunSummary summary) {
  summary.path_length = pathLength();
  summary.verdicts = verdicts_;
  writeRunSummary(file("run.json"), summary, stage_ms_);
  for (LineFile* lines : {&odometry_, &information_, &scan_times_}) lines->flush();
}

}  // namespace revisit_slam
