// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/simulation/route.h"

namespace revisit_slam::simulation {

enum class RevisitKind { kSame, kOpposite, kLateral, kCrossing };

std::string nameOf(RevisitKind kind);

/// Two stretches of the drive within 8 m of each other, the later more than 30 s and 50 m after the
/// earlier. `same` and `lateral` have the same heading within 45 degrees and differ by being less
/// or more than 2 m apart; `opposite` is beyond 135 degrees; between them is `crossing`.
struct Revisit {
  RevisitKind kind = RevisitKind::kSame;
  Stamp earlier_from;
  Stamp earlier_until;
  Stamp later_from;
  Stamp later_until;
};

std::vector<Revisit> findRevisits(const Route& route);

}  // namespace revisit_slam::simulation
