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

}  // namespace

LocalShape localShapeOf(const PointMoments& around, float edge) {
  const float points = around.count;
  if (points < kFewestPoints) return {ShapeKind::sparse, Eigen::Vector3f::Zero(), points};
  const PrincipalAxes principal = around.principalAxes();
  const float least = principal.variances[0], middle = principal.variances[1];
  const bool line = middle < kNarrowest * edge * edge;
  const bool upright = std::abs(principal.axes(2, 2)) > kUpright;
  if (line && !upright) return {ShapeKind::sparse, Eigen::Vector3f::Zero(), points};
  if (line || least > kThickest * middle)
    return {ShapeKind::scattered, Eigen::Vector3f::Zero(), points};
  return {ShapeKind::planar, principal.axes.col(0), points};
}

}  // namespace revisit_slam
