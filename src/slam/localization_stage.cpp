// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/localization_stage.h"

namespace revisit_slam {
namespace {

LocalizerConfig localizerConfig(const SlamConfig& config) {
  return {config.localization,
          config.loops,
          config.information,
          config.backend,
          config.mapping.submap_voxel_size,
          {config.mapping.follow_scale, config.odometry.map.voxel_size}};
}

}  // namespace

LocalizationStage::LocalizationStage(const SlamConfig& config, std::vector<std::string>& notices)
    : arena_(config.background.threads),
      map_(loadPriorMap(config.localization.map, config.loops.recognition,
                        config.mapping.cacheBytes(), notices)),
      localizer_(localizerConfig(config), map_) {}

Localization LocalizationStage::add(const InformedScan& informed) {
  return arena_.execute([&] { return localizer_.add(informed); });
}

}  // namespace revisit_slam
