// SPDX-License-Identifier: MIT
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <revisit_slam/LocalizationStatus.h>
#include <visualization_msgs/Marker.h>

#include <optional>
#include <string>

#include "revisit_slam/localization/prior_map.h"
#include "revisit_slam/slam/localization_stage.h"

namespace revisit_slam {

geometry_msgs::PoseWithCovarianceStamped toPoseWithCovariance(const Localization& now,
                                                              const std::string& map_frame);
LocalizationStatus toStatus(const Localization& now, const std::string& map_frame);
/// The state, and the reason why the last registration failed, as text above the base; above
/// `p_map_unknown` while it is not known where that is. The colour is that of the state.
visualization_msgs::Marker toStateText(const Localization& now,
                                       const Eigen::Vector3d& p_map_unknown,
                                       const std::string& map_frame);

/// What somebody has drawn on the map, on its ground; nothing for another frame.
std::optional<Pose> toStart(const geometry_msgs::PoseWithCovarianceStamped& drawn,
                            const std::string& map_frame, const PriorMap& map);

}  // namespace revisit_slam
