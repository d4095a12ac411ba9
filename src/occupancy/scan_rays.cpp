// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/scan_rays.h"

#include <cmath>
#include <limits>

#include "revisit_slam/geometry/voxel_walk.h"

namespace revisit_slam {
namespace {

const Voxel kNowhere = Voxel::Constant(std::numeric_limits<int>::max());
/// A ray that passed this many voxels one after another that rays passed before is on their way to
/// the sensor, and need not be followed (Oleynikova et al., Voxblox, IROS 2017).
constexpr int kJoined = 3;

bool sameBlock(const Voxel& a, const Voxel& b) {
  return ((a.x() ^ b.x()) | (a.y() ^ b.y()) | (a.z() ^ b.z())) >> 3 == 0;
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
  walkVoxels(end, sensor, [&](const Voxel& voxel) {
    if (!sameBlock(voxel, last)) miss = &table_.at(blockOf(voxel)).miss;
    last = voxel;
    const int bit = bitOf(voxel);
    passed_before = miss->test(bit) ? passed_before + 1 : 0;
    miss->set(bit);
    return passed_before < kJoined;
  });
}

}  // namespace revisit_slam
