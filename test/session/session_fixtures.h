// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/session/session_writer.h"
#include "support/synthetic_street.h"

namespace revisit_slam {

/// Scans and maps of a straight drive through a street, and back along it in another frame.
struct StreetDrive {
  std::vector<GraphNode> nodes;
  std::vector<MapUpdatePtr> updates;  ///< with a submap

  static const StreetDrive& get() {
    static const StreetDrive drive;
    return drive;
  }

  StreetDrive() {
    StoredParameters parameters;
    MapBuilder builder(parameters.mapping, parameters.occupancy);
    SyntheticStreet street(5, 1);
    for (const Pose& T : drive(0, 60)) {
      RegisteredScan scan;
      scan.id = ScanId{static_cast<std::uint32_t>(nodes.size())};
      scan.stamp = Stamp::fromSeconds(100.0 + 0.1 * static_cast<double>(nodes.size()));
      scan.T_odom_base = T;
      scan.points_base = street.scan(T);
      nodes.push_back({scan.id, scan.stamp, T, Matrix6::Identity()});
      keep(builder.insert(scan));
    }
    keep(builder.closeAll());
  }

  std::vector<GraphNode> nodesOf(const Submap& submap) const {
    return {nodes.begin() + submap.first_scan.value, nodes.begin() + submap.lastScan().value + 1};
  }

 private:
  void keep(MapUpdate update) {
    if (update.submap) updates.push_back(std::make_shared<const MapUpdate>(std::move(update)));
  }
};

inline SessionInfo someInfo() {
  StoredParameters parameters;
  SessionInfo info;
  info.software = softwareVersion();
  info.start = StreetDrive::get().nodes.front().stamp;
  info.map_frame = "map";
  info.odom_frame = "odom";
  info.base_frame = "base_link";
  info.sensor = "topic /points";
  info.parameters = textOf(parametersOf(parameters));
  return info;
}

/// The first submap is where the last one is, seen from it: a loop.
inline LoopConstraint someLoop() {
  const StreetDrive& drive = StreetDrive::get();
  const Submap &first = *drive.updates.front()->submap, &last = *drive.updates.back()->submap;
  LoopConstraint loop;
  loop.constraint.from = first.first_scan;
  loop.constraint.to = last.first_scan;
  loop.constraint.T_from_to = first.T_odom_submap.inverse() * last.T_odom_submap;
  loop.constraint.T_from_to.translation.y() += 0.4;
  loop.constraint.information = 50.0 * Matrix6::Identity();
  loop.target = first.id;
  loop.source = last.id;
  loop.fitness = 0.75;
  return loop;
}

/// A whole session, written through the writer.
inline void writeStreetSession(const std::string& folder, std::size_t submaps = 1000) {
  const StreetDrive& drive = StreetDrive::get();
  SessionWriter writer({folder, "", nullptr, false}, someInfo(), 0);
  for (std::size_t i = 0; i < std::min(submaps, drive.updates.size()); ++i) {
    const MapUpdatePtr& update = drive.updates[i];
    writer.add(drive.nodesOf(*update->submap), closedOf(*update->submap, update->detail_submap),
               update);
  }
  writer.close();
}

}  // namespace revisit_slam
