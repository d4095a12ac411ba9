// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/evaluation.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace revisit_slam {
namespace {

using nlohmann::json;

json number(double value) {
  return std::isfinite(value) ? json(value) : json();
}

json toJson(const AbsoluteError& error) {
  const Pose& T = error.T_reference_estimate;
  return {
      {"rmse_m", error.rmse},
      {"mean_m", error.mean},
      {"median_m", error.median},
      {"max_m", error.max},
      {"reference_from_estimate",
       {{"translation_m", {T.translation.x(), T.translation.y(), T.translation.z()}},
        {"quaternion_xyzw", {T.rotation.x(), T.rotation.y(), T.rotation.z(), T.rotation.w()}}}}};
}

json byLength(const std::vector<SubsequenceError>& subsequences) {
  struct Sums {
    std::size_t count = 0;
    double translation = 0.0, rotation = 0.0;
  };
  std::map<double, Sums> lengths;
  for (const SubsequenceError& error : subsequences) {
    Sums& sums = lengths[error.length];
    ++sums.count;
    sums.translation += error.translation;
    sums.rotation += error.rotation;
  }
  json rows = json::array();
  for (const auto& [length, sums] : lengths) {
    const auto count = static_cast<double>(sums.count);
    rows.push_back({{"length_m", length},
                    {"subsequences", sums.count},
                    {"translation_percent", 100.0 * sums.translation / count},
                    {"rotation_deg_per_m", 180.0 / M_PI * sums.rotation / count}});
  }
  return rows;
}

json toJson(const RelativeError& error) {
  return {{"translation_percent", number(error.translation_percent)},
          {"rotation_deg_per_m", number(error.rotation_deg_per_m)},
          {"subsequences", error.subsequences.size()},
          {"by_length", byLength(error.subsequences)}};
}

json toJson(const RevisitCell& cell) {
  json segments = json::array();
  for (const RevisitSegment& segment : cell.segments)
    segments.push_back(
        {stampText(segment.intervals.front().begin), stampText(segment.intervals.back().end)});
  return {{"index", {cell.index.x(), cell.index.y()}},
          {"centre_m", {cell.centre.x(), cell.centre.y()}},
          {"segments", segments}};
}

json toJson(const RmsStatistics& rms) {
  return {{"count", rms.count},
          {"mean_rms_m", number(rms.mean)},
          {"standard_deviation_m", number(rms.standard_deviation)}};
}

json toJson(const MapConsistency& consistency) {
  json cells = json::array(), worst = json::array();
  for (const CellConsistency& cell : consistency.cells) {
    cells.push_back(toJson(cell.cell));
    cells.back()["rms_m"] = cell.distances.rms();
    for (const NearestDistances& pair : cell.pairs)
      cells.back()["pairs_rms_m"].push_back(number(pair.rms()));
    cells.back()["points"] = cell.distances.points;
    cells.back()["paired"] = cell.distances.paired;
  }
  for (const CellMaps& maps : consistency.worst)
    worst.push_back({maps.cell.index.x(), maps.cell.index.y()});
  return {{"of_pairs", toJson(consistency.of_pairs)},
          {"of_cells", toJson(consistency.of_cells)},
          {"thickness_m", number(consistency.thickness.rms())},
          {"paired_share", number(consistency.share)},
          {"cells_without_pairs", consistency.cells_without_pairs},
          {"cells", cells},
          {"worst", worst}};
}

void addPosition(std::string& line, const Eigen::Vector3d& p) {
  char numbers[128];
  std::snprintf(numbers, sizeof(numbers), ",%.4f,%.4f,%.4f", p.x(), p.y(), p.z());
  line += numbers;
}

}  // namespace

TrajectoryEvaluation evaluateTrajectory(const PoseInterpolator& estimate,
                                        const PoseInterpolator& reference) {
  TrajectoryMatch match = matchToReference(estimate, reference);
  AbsoluteError absolute = absoluteError(match);
  RelativeError relative = relativeError(match);
  return {std::move(match), std::move(absolute), std::move(relative)};
}

json toJson(const EstimateEvaluation& evaluation) {
  json result = {{"name", evaluation.name}, {"poses", evaluation.estimate.size()}};
  if (const auto& trajectory = evaluation.trajectory) {
    result["judged_poses"] = trajectory->match.estimate.size();
    result["left_out"] = {{"outside_of_the_reference", trajectory->match.outside},
                          {"in_a_gap_of_the_reference", trajectory->match.in_gap}};
    result["ate"] = toJson(trajectory->absolute);
    result["rpe"] = toJson(trajectory->relative);
  }
  if (evaluation.consistency) {
    result["consistency"] = toJson(*evaluation.consistency);
    result["consistency"]["scans"] = evaluation.scans_used;
    result["consistency"]["scans_without_pose"] = evaluation.scans_without_pose;
  }
  return result;
}

std::string posesCsv(const EstimateEvaluation& evaluation) {
  if (!evaluation.trajectory) {
    std::string text = "stamp,x,y,z\n";
    for (const StampedPose& pose : evaluation.estimate) {
      text += stampText(pose.stamp);
      addPosition(text, pose.T_world_base.translation);
      text += "\n";
    }
    return text;
  }
  const auto& [match, absolute, relative] = *evaluation.trajectory;
  std::string text = "stamp,x,y,z,reference_x,reference_y,reference_z,error\n";
  for (std::size_t i = 0; i < match.estimate.size(); ++i) {
    text += stampText(match.estimate[i].stamp);
    addPosition(text, absolute.T_reference_estimate * match.estimate[i].T_world_base.translation);
    addPosition(text, match.reference[i].T_world_base.translation);
    char error[32];
    std::snprintf(error, sizeof(error), ",%.6f\n", absolute.per_pose[i]);
    text += error;
  }
  return text;
}

std::string worstCellsCsv(const MapConsistency& consistency) {
  std::string text = "cell,segment,x,y,z\n";
  for (std::size_t cell = 0; cell < consistency.worst.size(); ++cell) {
    const std::vector<Points>& maps = consistency.worst[cell].maps;
    for (std::size_t segment = 0; segment < maps.size(); ++segment)
      for (const Eigen::Vector3f& point : maps[segment]) {
        text += std::to_string(cell) + "," + std::to_string(segment);
        addPosition(text, point.cast<double>());
        text += "\n";
      }
  }
  return text;
}

}  // namespace revisit_slam
