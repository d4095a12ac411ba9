// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
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

/// Another passage of the same place, later in the session.
inline LocalMapPtr again(const LocalMap& map, const LocalMap& last) {
  auto later = std::make_shared<LocalMap>();
  later->id = {last.id.value + 1};
  std::uint32_t submaps = last.submaps.back()->id.value + 1;
  std::uint32_t scans = last.submaps.back()->lastScan().value + 1;
  for (const SubmapPtr& submap : map.submaps) {
    auto moved = std::make_shared<Submap>(*submap);
    moved->id = {submaps++};
    moved->local_map = later->id;
    moved->first_scan = {scans};
    moved->travelled_begin += last.submaps.back()->travelled_end;
    moved->travelled_end += last.submaps.back()->travelled_end;
    scans = moved->lastScan().value + 1;
    later->submaps.push_back(moved);
  }
  return later;
}

/// Likewise, with so many local maps of the one place in all.
inline std::vector<LocalMapPtr> streetPassages(int count) {
  std::vector<LocalMapPtr> maps = streetRevisit();
  for (int passage = 2; passage < count; ++passage) maps.push_back(again(*maps[2], *maps.back()));
  return maps;
}

}  // namespace revisit_slam
