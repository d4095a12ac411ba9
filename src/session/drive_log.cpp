// SPDX-License-Identifier: MIT
#include "revisit_slam/session/drive_log.h"

#include <sstream>

#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/types/loop_edge.h"

namespace revisit_slam {
namespace {

std::string informationHeader() {
  std::string header = "scan,stamp,source,mean_squared_residual,weak_directions";
  for (const char* matrix : {"information", "covariance"})
    for (int row = 1; row <= 6; ++row)
      for (int column = row; column <= 6; ++column)
        header += std::string(",") + matrix + std::to_string(row) + std::to_string(column);
  return header + ",verdict,explained,jump\n";
}

std::string timesHeader(const std::vector<std::string>& stages) {
  std::string header = "scan,stamp";
  for (const std::string& stage : stages) header += "," + stage + "_ms";
  return header + ",total_ms\n";
}

constexpr const char* kCandidatesHeader =
    "origin,target_map,source_map,target_submap,source_submap,outcome,value,limit,unit\n";

}  // namespace

DriveLogEntry entryOf(const InformedScan& informed, const StageTimes& times) {
  const RegisteredScan& scan = *informed.scan;
  return {scan.id,
          {scan.stamp, scan.T_odom_base},
          informed.source,
          informed.estimate.mean_squared_residual,
          informed.estimate.weak_directions.size(),
          informed.estimate.information,
          informed.covariance_motion,
          informed.verdict,
          scan.registration.explained,
          scan.jump,
          times};
}

DriveLog::DriveLog(const std::string& folder)
    : odometry_(folder + "/odometry.tum"),
      information_(folder + "/odometry_information.csv", informationHeader()),
      scan_times_(folder + "/scan_times.csv"),
      loop_candidates_(folder + "/loop_candidates.csv", kCandidatesHeader) {}

void DriveLog::add(const DriveLogEntry& entry) {
  std::ostringstream pose;
  writeTumLine(pose, entry.pose);
  odometry_.add(pose.str());
  const Eigen::Vector3d& position = entry.pose.T_world_base.translation;
  if (entry.scan.value == 0) distance_.goOnFrom(position);
  distance_.go(position);
  ++verdicts_[entry.verdict];
  writeInformation(entry);
  writeTimes(entry);
}

void DriveLog::writeInformation(const DriveLogEntry& entry) {
  std::ostringstream line;
  line << entry.scan.value << "," << stampText(entry.pose.stamp) << "," << toString(entry.source)
       << "," << entry.mean_squared_residual << "," << entry.weak_directions;
  for (const Matrix6* matrix : {&entry.information, &entry.covariance_motion})
    for (int row = 0; row < 6; ++row)
      for (int column = row; column < 6; ++column) line << "," << (*matrix)(row, column);
  line << "," << toString(entry.verdict) << "," << entry.explained << "," << entry.jump << "\n";
  information_.add(line.str());
}

void DriveLog::writeTimes(const DriveLogEntry& entry) {
  if (stages_.empty()) {
    for (const auto& [stage, ms] : entry.times) stages_.emplace_back(stage);
    scan_times_.setHeader(timesHeader(stages_));
  }
  std::map<std::string, double> ms_of;
  double total = 0.0;
  for (const auto& [stage, ms] : entry.times) {
    ms_of[stage] += ms;
    stage_ms_[stage].push_back(static_cast<float>(ms));
    total += ms;
  }
  std::ostringstream line;
  line << entry.scan.value << "," << stampText(entry.pose.stamp);
  for (const std::string& stage : stages_) line << "," << ms_of[stage];
  stage_ms_["total"].push_back(static_cast<float>(total));
  line << "," << total << "\n";
  scan_times_.add(line.str());
}

void DriveLog::add(const LoopCandidate& candidate) {
  std::ostringstream line;
  line << toString(candidate.origin) << ',' << candidate.target_map.value << ','
       << candidate.source_map.value << ',' << candidate.target.value << ','
       << candidate.source.value << ',' << candidate.outcome << ',';
  if (!candidate.isAccepted())
    line << candidate.value << ',' << candidate.limit << ',' << candidate.unit;
  else
    line << ",,";
  line << '\n';
  loop_candidates_.add(line.str());
}

void DriveLog::addTimes(const StageTimes& times) {
  for (const auto& [stage, ms] : times) stage_ms_[stage].push_back(static_cast<float>(ms));
}

void DriveLog::tell(RunSummary& summary) const {
  summary.processed = 0;
  for (const auto& [verdict, count] : verdicts_) summary.processed += count;
  summary.verdicts = verdicts_;
  summary.stage_ms = stage_ms_;
  summary.path_length = pathLength();
}

void DriveLog::flush() {
  for (LineFile* lines : {&odometry_, &information_, &scan_times_}) lines->flush();
  if (loop_candidates_.hasLines()) loop_candidates_.flush();
}

}  // namespace revisit_slam
