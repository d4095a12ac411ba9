// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "revisit_slam/evaluation/absolute_error.h"
#include "revisit_slam/evaluation/map_consistency.h"
#include "revisit_slam/evaluation/relative_error.h"

namespace revisit_slam {

/// Errors of an estimate against a reference.
struct TrajectoryEvaluation {
  TrajectoryMatch match;
  AbsoluteError absolute;
  RelativeError relative;
};

/// @throws std::runtime_error where fewer than three poses can be judged.
TrajectoryEvaluation evaluateTrajectory(const PoseInterpolator& estimate,
                                        const PoseInterpolator& reference);

/// All that is known of one estimate.
struct EstimateEvaluation {
  std::string name;
  Trajectory estimate;
  std::optional<TrajectoryEvaluation> trajectory;  ///< with a reference
  std::optional<MapConsistency> consistency;       ///< with scans
  std::size_t scans_used = 0;
  std::size_t scans_without_pose = 0;
};

/// Numbers that are not known (no subsequence, no revisit) are null.
nlohmann::json toJson(const EstimateEvaluation& evaluation);

/// What pictures are made of, as text: stamp, aligned position, position of the reference, error;
/// without a reference stamp and position alone.
std::string posesCsv(const EstimateEvaluation& evaluation);
/// The maps of the worst cells: rank from 0, segment from 0, x y z in the frame of the cell's maps.
std::string worstCellsCsv(const MapConsistency& consistency);

}  // namespace revisit_slam
