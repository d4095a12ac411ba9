// SPDX-License-Identifier: MIT
#pragma once

#include "site.h"

namespace revisit_slam::simulation {

/// Lamp posts and signs beside the roads.
void addLampsAndSigns(Site& site, double spacing);
/// Hedges, walls and fences along the front of open plots, `share` of the free roadside.
void addEnclosures(Site& site, double share);
/// Cars that stand at the roadside, out of the way of the platform. Of them a visit finds some
/// gone, and others in their place.
void addParkedCars(Site& site, double share, const Route& visit);
/// Cars that a visit finds where there were none, and nothing else is.
void addNewlyParkedCars(Site& site, double share, const Route& visit);
/// Benches, bins and steps beside paths.
void addBenches(Site& site, double spacing);
/// Rocks, stakes and hay bales on a field.
void addFieldObjects(Site& site, double density);

}  // namespace revisit_slam::simulation
