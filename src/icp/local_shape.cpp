// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/local_shape.h"

#include <cmath>

namespace revisit_slam {
namespace {

constexpr float kFewestPoints = 6.0f;
/// Points along a line have a middle variance below this share of the squared edge.
constexpr float kNarrowest = 0.02f;
/// Points on a plane have a least variance below this share of the middle one.
constexpr float kThickest = 0.1f;
/// A line with a larger vertical part is a pole, and no ring of a sensor.
constexpr float kUpright = 0.8f;
/// Edges that points may be off a plane that is seen farther around (standard deviation).
constexpr float kFarthestOff = 0.1f;

bool isLine(const PrincipalAxes& principal, float edge) {
  return principal.variances[1] < kNarrowest * edge * edge;
}

bool isThin(const PrincipalAxes& principal) {
  return principal.variances[0] <= kThickest * principal.variances[1];
}

}  // namespace

LocalShape localShapeOf(const PointMoments& around, float edge) {
  const Eigen::Vector3f none = Eigen::Vector3f::Zero();
  const float points = around.count;
  if (points < kFewestPoints) return {ShapeKind::sparse, none, points, true};
  const PrincipalAxes principal = around.principalAxes();
  if (isLine(principal, edge)) {
    const bool upright = std::abs(principal.axes(2, 2)) > kUpright;
    return {upright ? ShapeKind::scattered : ShapeKind::sparse, none, points, true};
  }
  if (!isThin(principal)) return {ShapeKind::scattered, none, points, false};
  return {ShapeKind::planar, principal.axes.col(0), points, false};
}

LocalShape widenedShapeOf(const LocalShape& line, const PointMoments& near,
                          const PointMoments& farther, float edge) {
  if (near.count == 0.0f || farther.count < kFewestPoints) return line;
  const PrincipalAxes principal = farther.principalAxes();
  const float farthest_off = kFarthestOff * edge;
  if (isLine(principal, kFartherEdges * edge) || !isThin(principal) ||
      principal.variances[0] > farthest_off * farthest_off)
    return line;
  const Eigen::Vector3f normal = principal.axes.col(0);
  const float off = normal.dot(near.sum / near.count - farther.sum / farther.count);
  if (std::abs(off) > farthest_off) return line;
  return {ShapeKind::planar, normal, line.points, true};
}

}  // namespace revisit_slam
