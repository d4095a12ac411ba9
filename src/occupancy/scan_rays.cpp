// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/scan_rays.h"

#include <cmath>
#include <limits>

namespace revisit_slam {
namespace {

const Voxel kNowhere = Voxel::Constant(std::numeric_limits<int>::max());
/// A ray that passed this many voxels one after another that rays passed before is on their way to
/// the sensor, and need not be followed (Oleynikova et al., Voxblox, IROS 2017).
constexpr int kJoined = 3;

bool sameBlock(const Voxel& a, const Voxel& b) {
  return ((a.x() ^ b.x()) | (a.y() ^ b.y()) | (a.z() ^ b.z())) >> 3 == 0;
}

/// Calls visit(voxel) for the voxels on the line, from the one behind that of `from` up to that of
/// `to`, as long as it returns true; coordinates in voxels (Amanatides and Woo, 1987).
template <typename Visit>
void walk(const Eigen::Vector3f& from, const Eigen::Vector3f& to, Visit visit) {
  Voxel voxel = voxelOf<float>(from);
  const Voxel way = voxelOf<float>(to) - voxel;
  const Eigen::Vector3f direction = to - from;
  Eigen::Vector3f next,
      apart;  // share of the line up to the next border, and between two, per axis
  Voxel step;
  for (int axis = 0; axis < 3; ++axis) {
    step[axis] = way[axis] < 0 ? -1 : 1;
    const float border = static_cast<float>(voxel[axis] + (way[axis] < 0 ? 0 : 1));
    const bool crosses = way[axis] != 0;
    const float none = std::numeric_limits<float>::infinity();
    apart[axis] = crosses ? static_cast<float>(step[axis]) / direction[axis] : none;
    next[axis] = crosses ? (border - from[axis]) / direction[axis] : none;
  }
  for (int left = way.cwiseAbs().sum(); left > 0; --left) {
    const int axis =
        next.x() < next.y() ? (next.x() < next.z() ? 0 : 2) : (next.y() < next.z() ? 1 : 2);
    voxel[axis] += step[axis];
    next[axis] += apart[axis];
    if (!visit(voxel)) return;
  }
}

}  // namespace

const std::vector<ScanRaysBlock>& ScanRays::cast(const Points& points, const Pose& T_g_b,
                                                 const std::vector<PointsView>& views_b) {
  table_.clear();
  const Eigen::Matrix3f R = scale_ * T_g_b.rotationMatrix().cast<float>();
  const Eigen::Vector3f t = scale_ * T_g_b.translation.cast<float>();
  std::size_t i = 0;
  for (const PointsView& view : views_b) {
    previous_ = kNowhere;
    const Eigen::Vector3f from = R * view.sensor_base.cast<float>() + t;
    for (; i < view.end; ++i) castFrom(from, R * points[i] + t);
  }
  for (ScanRaysBlock& block : table_.blocks()) block.miss = block.miss & ~block.hit;
  return table_.blocks();
}

/// Both in voxels.
void ScanRays::castFrom(const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
  const float longest = scale_ * max_ray_;
  const float squared_length = (to - from).squaredNorm();
  const bool hit = squared_length <= longest * longest;
  const Eigen::Vector3f cut =
      hit ? to : Eigen::Vector3f(from + (to - from) * (longest / std::sqrt(squared_length)));
  const Voxel end = voxelOf<float>(cut);
  if (hit && end == previous_) return;
  if (hit) previous_ = end;
  ScanRaysBlock& block = table_.at(blockOf(end));
  VoxelMask& ends = hit ? block.hit : block.cut;
  const int bit = bitOf(end);
  if (ends.test(bit)) return;
  ends.set(bit);
  clear(cut, from);
}

void ScanRays::clear(const Eigen::Vector3f& end, const Eigen::Vector3f& sensor) {
  Voxel last = kNowhere;
  VoxelMask* miss = nullptr;
  int passed_before = 0;
  walk(end, sensor, [&](const Voxel& voxel) {
    if (!sameBlock(voxel, last)) miss = &table_.at(blockOf(voxel)).miss;
    last = voxel;
    const int bit = bitOf(voxel);
    passed_before = miss->test(bit) ? passed_before + 1 : 0;
    miss->set(bit);
    return passed_before < kJoined;
  });
}

}  // namespace revisit_slam
