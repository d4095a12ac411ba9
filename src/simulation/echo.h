// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "revisit_slam/simulation/ray_caster.h"

namespace revisit_slam::simulation {

/// Whether too little light comes back: far, dark or grazed surfaces, glass, and sheer chance.
bool isLost(const RayHit& hit, double random_dropout, std::uint64_t hash);

/// 0 to 255, corrected for range but not for the angle, with noise.
float intensityOf(const RayHit& hit, std::uint64_t hash);

}  // namespace revisit_slam::simulation
