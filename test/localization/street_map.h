// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "revisit_slam/localization/prior_map.h"
#include "revisit_slam/types/informed_scan.h"
#include "support/synthetic_street.h"

namespace revisit_slam {

/// The map of a drive along a street from x = 0 to 60. Its frame is 100 m off that of the street.
inline Pose T_map_street() {
  return {Eigen::Quaterniond::Identity(), {100.0, 0.0, 0.0}};
}

inline PriorMapPtr streetMap() {
  static const PriorMapPtr map = [] {
    SyntheticStreet street(5, 1);
    auto prior = std::make_shared<PriorMap>();
    prior->library = std::make_shared<SubmapLibrary>(0);
    for (const double from : {0.0, 20.0, 40.0}) {
      const std::vector<Pose> way = drive(from, from + 20.0);
      Submap submap = submapOf(street, way);
      submap.id.value = static_cast<std::uint32_t>(prior->submaps.size());
      const Pose T_map_submap = T_map_street() * submap.T_odom_submap;
      const auto whole = std::make_shared<const Submap>(std::move(submap));
      prior->library->add(whole, nullptr);
      prior->submaps.push_back({prior->library->light(whole->id), T_map_submap});
      for (const Pose& T : way) prior->T_map_scan.push_back(T_map_street() * T);
    }
    return prior;
  }();
  return map;
}

/// Scans of another drive along the street, seen from an odometry frame where the drive begins.
inline std::vector<InformedScan> scansAlong(const std::vector<Pose>& T_street_base) {
  SyntheticStreet street(5, 2);
  std::vector<InformedScan> scans;
  for (const Pose& T : T_street_base) {
    auto scan = std::make_shared<RegisteredScan>();
    scan->id.value = static_cast<std::uint32_t>(scans.size());
    scan->stamp = Stamp::fromSeconds(100.0 + 0.1 * static_cast<double>(scans.size()));
    scan->T_odom_base = T_street_base.front().inverse() * T;
    scan->points_base = street.scan(T);
    InformedScan informed;
    informed.scan = scan;
    informed.estimate.information = 1e4 * Matrix6::Identity();
    informed.covariance_motion = 1e-6 * Matrix6::Identity();
    scans.push_back(informed);
  }
  return scans;
}

}  // namespace revisit_slam
