// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/mapping/dynamic_point_filter.h"
#include "revisit_slam/mapping/map_builder.h"

namespace revisit_slam {

/// The detail points of a submap in the map, with when and from where they were seen, from its
/// records trajectory, detail and sightings. None where the sightings are not known.
/// @param start from which times count.
SeenPoints seenPoints(const MapUpdate& update, const Pose& T_map_submap, Stamp start);

}  // namespace revisit_slam
