// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/nearest_distances.h"

#include <cmath>
#include <vector>

#include "revisit_slam/loops/registration/fine_registration_surfels.h"
#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

const Eigen::Vector3f kAnyNormal = Eigen::Vector3f::Zero();

SurfelGrid gridOf(const Points& points, double reach) {
  Surfels surfels;
  surfels.reserve(points.size());
  for (const Eigen::Vector3f& point : points) surfels.push_back({point, kAnyNormal});
  return SurfelGrid(surfels, reach);
}

NearestDistances distancesTo(const SurfelGrid& grid, const Points& points, double max_distance) {
  const auto limit = static_cast<float>(max_distance);
  const Chunks chunks(points.size(), 2048);
  std::vector<NearestDistances> parts(chunks.size());
  chunks.forEach([&](std::size_t index, Chunk chunk) {
    NearestDistances& part = parts[index];
    part.points = chunk.end - chunk.begin;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Surfel* neighbour = grid.nearest(points[i], kAnyNormal, limit);
      if (neighbour == nullptr) continue;
      ++part.paired;
      part.squared_sum += (neighbour->point - points[i]).squaredNorm();
    }
  });
  NearestDistances sum;
  for (const NearestDistances& part : parts) sum += part;
  return sum;
}

}  // namespace

NearestDistances& NearestDistances::operator+=(const NearestDistances& other) {
  points += other.points;
  paired += other.paired;
  squared_sum += other.squared_sum;
  return *this;
}

double NearestDistances::rms() const {
  return std::sqrt(squared_sum / static_cast<double>(paired));
}

double NearestDistances::share() const {
  return static_cast<double>(paired) / static_cast<double>(points);
}

NearestDistances nearestDistances(const Points& a, const Points& b, double max_distance) {
  NearestDistances sum = distancesTo(gridOf(b, max_distance), a, max_distance);
  return sum += distancesTo(gridOf(a, max_distance), b, max_distance);
}

}  // namespace revisit_slam
