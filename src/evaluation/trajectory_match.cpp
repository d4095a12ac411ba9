// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/trajectory_match.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace revisit_slam {
namespace {

/// Number of columns of the first line that is neither empty nor a comment; 0 without one.
int columnsOf(const std::string& path) {
  std::ifstream file(path);
  for (std::string line, word; std::getline(file, line);) {
    std::istringstream words(line);
    int count = 0;
    while (words >> word) ++count;
    if (count > 0 && line[0] != '#') return count;
  }
  return 0;
}

Trajectory stampedAs(const Trajectory& reference, const std::vector<Pose>& poses,
                     const std::string& path) {
  if (poses.size() != reference.size())
    throw std::runtime_error("'" + path + "' has " + std::to_string(poses.size()) +
                             " poses without stamps, the reference " +
                             std::to_string(reference.size()) +
                             ": which belongs to which is not known");
  Trajectory trajectory;
  for (std::size_t i = 0; i < poses.size(); ++i)
    trajectory.push_back({reference[i].stamp, poses[i]});
  return trajectory;
}

}  // namespace

TrajectoryMatch matchToReference(const PoseInterpolator& estimate,
                                 const PoseInterpolator& reference) {
  TrajectoryMatch match;
  for (const StampedPose& pose : estimate.poses()) {
    const PoseAnswer truth = reference.at(pose.stamp);
    match.outside += truth.kind == PoseAnswer::Kind::outside;
    match.in_gap += truth.kind == PoseAnswer::Kind::in_gap;
    if (!truth) continue;
    match.estimate.push_back(pose);
    match.reference.push_back({pose.stamp, truth.T_world_base});
  }
  return match;
}

Trajectory readTrajectory(const std::string& path, const Trajectory& reference) {
  constexpr int kitti_columns = 12;
  Trajectory trajectory = columnsOf(path) == kitti_columns
                              ? stampedAs(reference, readKitti(path), path)
                              : readTum(path);
  if (trajectory.empty()) throw std::runtime_error("no pose in '" + path + "'");
  return trajectory;
}

}  // namespace revisit_slam
