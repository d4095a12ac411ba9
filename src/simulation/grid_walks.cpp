// SPDX-License-Identifier: MIT
#include "grid_walks.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

/// Around a rectangle of blocks; the second lap fits to 60 % into the length.
GridWalk ring(double length, double usual_block) {
  const double edges = 0.6 * length / usual_block;
  const int half = std::max(2, static_cast<int>(edges / 2.0));
  const int a = (half + 1) / 2, b = half / 2;
  std::vector<GridNode> lap;
  for (int i = 0; i < a; ++i) lap.push_back({i, 0});
  for (int j = 0; j < b; ++j) lap.push_back({a, j});
  for (int i = a; i > 0; --i) lap.push_back({i, b});
  for (int j = b; j >= 0; --j) lap.push_back({0, j});
  return {lap, true, std::min(usual_block, 0.6 * length / (2.0 * half))};
}

/// Each lap is a closed walk of which `edges_needed` streets contain the promised revisit.
GridWalk closedWalk(std::vector<GridNode> lap, double edges_needed, double length,
                    double usual_block) {
  return {std::move(lap), true, std::min(usual_block, length / edges_needed)};
}

std::vector<GridNode> randomWalk(std::uint64_t seed, int edges) {
  const int bound = edges < 20 ? 1 : edges < 60 ? 2 : 3;
  Random random(hashOf(seed, 900));
  std::vector<GridNode> walk{{0, 0}};
  GridNode step{1, 0};
  while (static_cast<int>(walk.size()) <= edges) {
    const double turn = random.uniform(0.0, 1.0);
    GridNode next = step;
    if (turn < 0.3) next = {-step.j, step.i};
    if (turn > 0.7) next = {step.j, -step.i};
    const GridNode node{walk.back().i + next.i, walk.back().j + next.j};
    if (std::abs(node.i) > bound || std::abs(node.j) > bound) continue;
    walk.push_back(node);
    step = next;
  }
  return walk;
}

GridWalk bridgeTour(double block) {
  return {
      {{-1, 0}, {0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}, {0, 0}, {0, -1}, {-1, -1}, {-1, 0}},
      true,
      block};
}

}  // namespace

GridWalk makeWalk(const RouteConfig& config, double usual_block) {
  const double length = config.length;
  if (config.world == WorldKind::kBridge) return bridgeTour(usual_block);
  if (config.route == "loop" || config.route == "lateral") return ring(length, usual_block);
  if (config.route == "opposite") {
    return closedWalk({{0, 0},
                       {1, 0},
                       {1, 1},
                       {0, 1},
                       {0, 0},
                       {0, -1},
                       {1, -1},
                       {1, 0},
                       {0, 0},
                       {-1, 0},
                       {-1, -1},
                       {0, -1},
                       {0, 0}},
                      8.5, length, usual_block);
  }
  if (config.route == "crossing") {
    return closedWalk({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {0, 0}},
                      6.5, length, 2.0 * usual_block);
  }
  if (config.route == "figure-eight") {
    return closedWalk({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {-1, 0}, {-1, -1}, {0, -1}, {0, 0}},
                      10.0, length, usual_block);
  }
  const double block = std::min(usual_block, length / 8.0);
  return {randomWalk(config.seed, static_cast<int>(1.3 * length / block) + 3), false, block};
}

}  // namespace revisit_slam::simulation
