// SPDX-License-Identifier: MIT
#pragma once

#include "site.h"

namespace revisit_slam::simulation {

/// The deck of the bridge with its railings, posts and lamps.
void addBridge(Site& site);
/// The helices, the upper deck with its columns and parapets, and the cars that stand there.
void addParkingDeck(Site& site);
/// A smooth ceiling and walls with few doors on both sides of the route.
void addCorridor(Site& site);
/// Guard rails, boards, gantries, posts, bushes and trees, and bare stretches between them.
void addMotorway(Site& site);

/// What stands beside the lanes of equal_rows.h, all alike.
void addEqualRows(Site& site);
/// The building of storeys.h with its ramps, each storey like the others.
void addStoreys(Site& site);

}  // namespace revisit_slam::simulation
