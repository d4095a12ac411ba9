// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/simulation/mover.h"
#include "site.h"

namespace revisit_slam::simulation {

int personModelCount();

/// Somebody in mid-stride on the ground, x forward, the origin below the middle.
void addPerson(TriangleMesh& mesh, int model);

/// People who walk along and across the way while the platform of the `visit` is near, at most
/// `most` of them. They keep off what stands on the site and out of the platform's way.
/// @param first_model the number of the first model of people in World::models.
std::vector<Mover> makePeople(Site& site, const Route& visit, int most, int first_model);

}  // namespace revisit_slam::simulation
