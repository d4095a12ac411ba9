// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "revisit_slam/mapping/map_builder.h"

namespace revisit_slam {

/// The records of a submap's file (docs/session_format.md).
enum class SubmapRecord : std::uint32_t {
  submap = 1,
  trajectory = 2,
  points = 3,
  normals = 4,
  detail = 5,
  occupancy = 6,
  sightings = 7,
  intensities = 8,
};

/// A closed submap as bytes of its file, NNNNNN.rsm.
std::string encodeSubmap(const MapUpdate& update);

/// What is wanted of a submap's file, and the ids in any case. What a file does not have stays
/// empty.
/// @throws std::runtime_error naming a file that cannot be read, or in which something wanted is
/// damaged.
MapUpdate readSubmap(const std::string& path, const std::set<SubmapRecord>& wanted);

}  // namespace revisit_slam
