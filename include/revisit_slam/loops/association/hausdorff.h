// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace revisit_slam {

/// Positions along a trajectory, in order, with the travelled distance to each. It bounds how much
/// the distance to anything else can change from one position to the next, which lets the searches
/// below leap over positions that cannot matter.
class Path {
 public:
  Path() = default;
  explicit Path(std::vector<Eigen::Vector3d> positions);

  std::size_t size() const { return positions_.size(); }
  const Eigen::Vector3d& operator[](std::size_t index) const { return positions_[index]; }
  double length() const { return travelled_.empty() ? 0.0 : travelled_.back(); }

  /// The first index after `index` that is more than `distance` further on.
  std::size_t leap(std::size_t index, double distance) const;

  /// Distance from `p` to the nearest position, or one that is not above `enough`.
  double distanceTo(const Eigen::Vector3d& p, double enough = 0.0) const;

 private:
  std::vector<Eigen::Vector3d> positions_;
  std::vector<double> travelled_;  // m, from the first position
};

constexpr double kAnyDistance = std::numeric_limits<double>::infinity();

/// d_H (paper Eq. hausdorff) in metres, exact; infinity as soon as it is known to exceed `limit`,
/// and where a path is empty. The direction of travel does not matter.
double hausdorffDistance(const Path& a, const Path& b, double limit = kAnyDistance);

/// Whether the paths come nearer to each other than `distance`.
bool comeWithin(const Path& a, const Path& b, double distance);

}  // namespace revisit_slam
