// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/ambiguity.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/geometry/voxel_numbers.h"

namespace revisit_slam {
namespace {

constexpr float kEdge = 0.5f;          // m, of the cells that are compared, times the scale
constexpr int kNearest = 4;            // steps of half an edge: nearer poses are the same optimum
constexpr std::size_t kSamples = 500;  // of the source
constexpr float kUpright = 0.7f;       // largest part of a normal along z
constexpr std::size_t kFewest = 50;    // samples that fit; with fewer nothing is said

bool isUpright(const Eigen::Vector3f& normal, const Eigen::Vector3f& up) {
  return std::abs(normal.dot(up)) < kUpright;
}

Points uprightOf(const Submap& submap, const Eigen::Vector3f& up) {
  Points points;
  for (std::size_t i = 0; i < submap.points.size(); ++i)
    if (isUpright(submap.normals[i], up)) points.push_back(submap.points[i]);
  return points;
}

Points evenly(const Points& points, std::size_t count) {
  if (points.size() <= count) return points;
  Points chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(points[i * points.size() / count]);
  return chosen;
}

/// The cells that the target fills, and samples of the source that may fill them, too.
class Overlay {
 public:
  Overlay(const Submap& source, const Submap& target, const Pose& T, float edge) : edge_(edge) {
    const Eigen::Matrix3f R = T.rotationMatrix().cast<float>();
    const Eigen::Vector3f t = T.translation.cast<float>();
    for (const Eigen::Vector3f& point : uprightOf(target, Eigen::Vector3f::UnitZ()))
      cells_.tryEmplace(voxelOf<float>(point / edge), 0);
    for (const Eigen::Vector3f& point : uprightOf(source, R.transpose().col(2))) {
      const Eigen::Vector3f moved = R * point + t;
      samples_.push_back(moved);
    }
    samples_ = evenly(samples_, kSamples);
  }

  /// How many samples fill cells when shifted by these steps of half an edge.
  std::size_t score(int x, int y) const {
    const Eigen::Vector3f shift = 0.5f * edge_ * Eigen::Vector3f(x, y, 0);
    VoxelNumbers::Reader cells(cells_);
    std::size_t filled = 0;
    for (const Eigen::Vector3f& sample : samples_)
      filled += cells.at(voxelOf<float>((sample + shift) / edge_)) != VoxelNumbers::kNone;
    return filled;
  }

 private:
  float edge_;
  VoxelNumbers cells_;  // all of number 0
  Points samples_;
};

}  // namespace

double rivalShare(const Submap& source, const Submap& target, const Pose& T_target_source,
                  double radius) {
  const float edge = kEdge * static_cast<float>(std::max(source.scale, target.scale));
  const int reach = static_cast<int>(std::floor(radius / (0.5 * edge)));
  if (reach < kNearest) return 0.0;
  const Overlay overlay(source, target, T_target_source, edge);
  std::size_t best = 0, rival = 0;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y) {
      const int squared = x * x + y * y;
      if (squared <= 2) best = std::max(best, overlay.score(x, y));
      if (squared >= kNearest * kNearest && squared <= reach * reach)
        rival = std::max(rival, overlay.score(x, y));
    }
  return best < kFewest ? 0.0 : static_cast<double>(rival) / static_cast<double>(best);
}

}  // namespace revisit_slam
