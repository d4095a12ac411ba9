// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include <string>
#include <vector>

#include "revisit_slam/localization/localizer.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// Localization as a stage: informed scans in, where they are in the map of localization/map out.
class LocalizationStage {
 public:
  /// What cannot be used of the map is named in `notices`.
  /// @throws std::runtime_error where there is no map to use, ParameterError for a start that is no
  /// pose.
  LocalizationStage(const SlamConfig& config, std::vector<std::string>& notices);

  Localization add(const InformedScan& informed);
  void startAt(const Pose& T_map_base) { localizer_.startAt(T_map_base); }

  const PriorMap& map() const { return *map_; }

 private:
  tbb::task_arena arena_;
  PriorMapPtr map_;
  Localizer localizer_;
};

}  // namespace revisit_slam
