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

}  // namespace revisit_slam::simulation
