// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/ground_alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {
namespace {

using Ground = std::vector<Eigen::Vector3d>;

constexpr double kColumn = 1.0;  // m
constexpr std::size_t kMinColumns = 10;
constexpr double kCoarsestScale = 8.0;  // m, above which a column counts little
constexpr double kFinestScale = 0.5;    // m
constexpr int kStepsPerScale = 3;
constexpr float kFarthest = 1e3f;  // m; no map is as large

/// A number for each column of the square around the origin that a turned map covers.
class Columns {
 public:
  static constexpr int kNew = -1;

  explicit Columns(double reach)
      : half_(static_cast<int>(reach / kColumn) + 2),
        numbers_(static_cast<std::size_t>(4 * half_ * half_), kNew) {}

  int& at(const Eigen::Vector3d& p) {
    const int i = floorToInt(p.x() / kColumn) + half_, j = floorToInt(p.y() / kColumn) + half_;
    return numbers_[static_cast<std::size_t>(j * 2 * half_ + i)];
  }

 private:
  int half_;
  std::vector<int> numbers_;
};

/// m, from the origin to the farthest point that counts.
double reachOf(const Points& points_local) {
  float squared = 0.0f;
  for (const Eigen::Vector3f& p : points_local)
    if (p.squaredNorm() < kFarthest * kFarthest) squared = std::max(squared, p.squaredNorm());
  return std::sqrt(squared);
}

/// The lowest point of each column, in the level frame.
/// @param T_level_local  moves along z only
Ground lowestPoints(const Points& points_local, const Pose& T_level_local, double reach) {
  Ground lowest;
  Columns columns(reach);
  for (const Eigen::Vector3f& point : points_local) {
    if (!(point.squaredNorm() < kFarthest * kFarthest)) continue;  // not a number: neither
    const Eigen::Vector3d p = T_level_local * point.cast<double>();
    int& number = columns.at(p);
    if (number == Columns::kNew) {
      number = static_cast<int>(lowest.size());
      lowest.push_back(p);
    } else if (p.z() < lowest[static_cast<std::size_t>(number)].z()) {
      lowest[static_cast<std::size_t>(number)] = p;
    }
  }
  return lowest;
}

/// z = a + b x + c y.
struct Plane {
  double a = 0.0, b = 0.0, c = 0.0;

  double heightAbove(const Eigen::Vector3d& p) const { return p.z() - (a + b * p.x() + c * p.y()); }
};

double medianHeight(Ground ground) {
  const auto middle = ground.begin() + static_cast<std::ptrdiff_t>(ground.size() / 2);
  std::nth_element(ground.begin(), middle, ground.end(),
                   [](const auto& p, const auto& q) { return p.z() < q.z(); });
  return middle->z();
}

/// One step of iteratively reweighted least squares with the Geman-McClure kernel.
Plane refit(const Plane& plane, const Ground& ground, double scale) {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : ground) {
    const double ratio = plane.heightAbove(p) / scale;
    const double weight = 1.0 / ((1.0 + ratio * ratio) * (1.0 + ratio * ratio));
    const Eigen::Vector3d J(1.0, p.x(), p.y()), weighted = weight * J;
    H.noalias() += weighted * J.transpose();
    g.noalias() += weighted * p.z();
  }
  H.diagonal() +=
      Eigen::Vector3d(1e-9, 1e-6, 1e-6) * H(0, 0);  // columns in a line: no slope across
  const Eigen::Vector3d solution = H.ldlt().solve(g);
  return {solution[0], solution[1], solution[2]};
}

/// From a wide kernel to a narrow one, so that a wrong start does not decide what is ground.
Plane fitPlane(const Ground& ground, Plane plane, double coarsest_scale) {
  for (double scale = coarsest_scale; scale >= kFinestScale; scale *= 0.5)
    for (int i = 0; i < kStepsPerScale; ++i) plane = refit(plane, ground, scale);
  return plane;
}

/// The pose that makes a plane z = 0 and moves the origin along z only.
Pose levelling(const Plane& plane) {
  const Eigen::Vector3d normal = Eigen::Vector3d(-plane.b, -plane.c, 1.0).normalized();
  const auto rotation = Eigen::Quaterniond::FromTwoVectors(normal, Eigen::Vector3d::UnitZ());
  return {rotation, {0.0, 0.0, -normal.z() * plane.a}};
}

}  // namespace

Pose levelOnGround(const Points& points_local) {
  const double reach = reachOf(points_local);
  Ground ground = lowestPoints(points_local, {}, reach);
  if (ground.size() < kMinColumns) return {};
  Pose T_level_local = levelling(fitPlane(ground, {medianHeight(ground)}, kCoarsestScale));
  ground =
      lowestPoints(points_local, T_level_local, reach);  // once level, columns hold other points
  T_level_local = levelling(fitPlane(ground, {}, 2.0 * kFinestScale)) * T_level_local;
  const Eigen::Vector3d up = T_level_local.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  const auto without_yaw = Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ());
  return {without_yaw, {0.0, 0.0, T_level_local.translation.z()}};
}

}  // namespace revisit_slam
