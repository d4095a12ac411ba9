// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/mapping/map_hierarchy.h"
#include "support/random_numbers.h"

namespace revisit_slam {

/// A straight street along x from -60 to `length` + 60 m: ground, houses that stand forward and
/// back with gaps between, poles. As a corridor: two bare walls, floor and ceiling.
class SyntheticStreet {
 public:
  /// `layout`: the same number is the same street. `sampling`: where the points fall.
  explicit SyntheticStreet(unsigned layout, unsigned sampling, double length = 60.0)
      : layout_(layout), sampling_(sampling) {
    const double first = -60.0, last = length + 60.0;
    addRectangle({first, -20, 0}, {last - first, 0, 0}, {0, 40, 0});
    for (const double side : {-1.0, 1.0})
      for (double x = first; x < last;) {
        const double width = layout_.uniform(6, 14), front = side * layout_.uniform(7, 11);
        const double height = layout_.uniform(4, 9);
        addRectangle({x, front, 0}, {width, 0, 0}, {0, 0, height});
        for (const double end : {x, x + width})
          addRectangle({end, front, 0}, {0, 8 * side, 0}, {0, 0, height});
        addPole(x - layout_.uniform(1, 3), 5.5 * side);
        x += width + layout_.uniform(2, 8);
      }
  }

  static SyntheticStreet corridor(unsigned sampling) {
    SyntheticStreet street(sampling);
    for (const double z : {0.0, 3.0}) street.addRectangle({-60, -2, z}, {180, 0, 0}, {0, 4, 0});
    for (const double y : {-2.0, 2.0}) street.addRectangle({-60, y, 0}, {180, 0, 0}, {0, 0, 3});
    return street;
  }

  /// Every fifth point within 40 m, with noise of 2 cm, in the frame of the base.
  Points scan(const Pose& T_street_base) {
    Points points;
    const Pose T_base_street = T_street_base.inverse();
    for (const Eigen::Vector3d& p : points_) {
      if ((p - T_street_base.translation).norm() > 40.0 || sampling_.uniform(0, 1) > 0.2) continue;
      Eigen::Vector3d noise;  // one after the other: compilers differ in the order of arguments
      for (const int axis : {2, 1, 0}) noise[axis] = sampling_.gaussian(0.02);
      points.push_back((T_base_street * (p + noise)).cast<float>());
    }
    return points;
  }

 private:
  explicit SyntheticStreet(unsigned sampling) : layout_(0), sampling_(sampling) {}

  void addRectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b) {
    for (int n = static_cast<int>(20.0 * a.norm() * b.norm()); n > 0; --n) {
      const double along_b = sampling_.uniform(0, 1), along_a = sampling_.uniform(0, 1);
      points_.push_back(corner + along_a * a + along_b * b);
    }
  }
  void addPole(double x, double y) {
    for (int n = 0; n < 60; ++n) points_.emplace_back(x, y, sampling_.uniform(0, 5));
  }

  RandomNumbers layout_, sampling_;
  std::vector<Eigen::Vector3d> points_;
};

inline Pose poseAt(double x, double y, double yaw = 0.0) {
  return {expSO3({0, 0, yaw}), {x, y, 1.5}};
}

/// The closed submap of a drive along `T_street_scan`; its odometry is that of the street.
inline Submap submapOf(SyntheticStreet& street, const std::vector<Pose>& T_street_scan) {
  SubmapBuilder builder(0.5);
  unsigned id = 0;
  for (const Pose& T : T_street_scan) builder.insert({id++}, Stamp{}, T, street.scan(T));
  return builder.close({}, {});
}

/// A drive from x = `from` to `to` in steps of 5 m, backwards where `to` is the smaller.
inline std::vector<Pose> drive(double from, double to, double y = 0.0) {
  std::vector<Pose> poses;
  const double forward = to > from ? 1.0 : -1.0;
  for (double s = 0.0; s <= std::abs(to - from); s += 5.0)
    poses.push_back(poseAt(from + forward * s, y, forward > 0 ? 0.0 : M_PI));
  return poses;
}

}  // namespace revisit_slam
