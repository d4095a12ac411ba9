// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "support/synthetic_street.h"

namespace revisit_slam {

/// Out along a street, 150 m elsewhere, and back along it: three local maps of which the first and
/// the last show one place.
inline std::vector<LocalMapPtr> streetRevisit() {
  MapHierarchy hierarchy{MappingConfig{}};
  SyntheticStreet out(5, 1), back(5, 2);
  std::uint32_t id = 0;
  const auto insert = [&](const Pose& T, SyntheticStreet& street) {
    hierarchy.insert({id++}, {}, T, street.scan(T));
  };
  std::vector<LocalMapPtr> maps;
  for (const Pose& T : drive(0, 50)) insert(T, out);
  maps.push_back(hierarchy.closeAll().local_map);
  for (double y = 5.0; y <= 95.0; y += 5.0) insert(poseAt(1050, y), out);
  maps.push_back(hierarchy.closeAll().local_map);
  for (const Pose& T : drive(52, 2, 2.0)) insert(T, back);
  maps.push_back(hierarchy.closeAll().local_map);
  return maps;
}

}  // namespace revisit_slam
