// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/voxel_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

/// The first point of each voxel, in the order of the input.
Points firstOfEachVoxel(const Points& input, double voxel_size) {
  const float scale = static_cast<float>(1.0 / voxel_size);
  std::map<std::array<int, 3>, std::size_t> seen;
  Points output;
  for (const Eigen::Vector3f& point : input) {
    const Eigen::Vector3i voxel = (point * scale).array().floor().cast<int>();
    if (seen.emplace(std::array<int, 3>{voxel.x(), voxel.y(), voxel.z()}, 0).second)
      output.push_back(point);
  }
  return output;
}

TEST(VoxelFilter, KeepsTheFirstPointOfEachVoxelInOrder) {
  RandomNumbers random(1);
  VoxelFilter filter;  // one for all calls: its table is used again and grows
  Points output{{9, 9, 9}};
  for (const std::size_t count : {0u, 1u, 100u, 20000u, 300u, 5000u, 0u, 70000u, 1000u})
    for (const auto& [voxel_size, half] :
         {std::pair{0.5, 3.0}, {1.0, 30.0}, {0.1, 100.0}, {0.003, 150.0}, {7.0, 1.0}}) {
      const Points input = random.cloud(count, half);
      filter.filter(input, voxel_size, output);
      ASSERT_EQ(output, firstOfEachVoxel(input, voxel_size)) << count << " points, " << voxel_size;
    }
}

TEST(VoxelFilter, HashedKeepsTheSamePointsInAnotherOrder) {
  RandomNumbers random(3);
  const Points input = random.cloud(5000, 10.0);
  VoxelFilter filter;
  Points in_order, hashed, again;
  filter.filter(input, 1.0, in_order);
  const VoxelFilter::Indices kept = filter.filterHashed(input, 1.0, hashed);
  ASSERT_EQ(kept.size(), hashed.size());
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(input[kept[i]], hashed[i]);
  filter.filterHashed(input, 1.0, again);
  EXPECT_EQ(again, hashed);
  EXPECT_NE(hashed, in_order);
  const auto less = [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(hashed.begin(), hashed.end(), less);
  std::sort(in_order.begin(), in_order.end(), less);
  EXPECT_EQ(hashed, in_order);
}

TEST(VoxelFilter, ForgetsEarlierCalls) {
  RandomNumbers random(2);
  const Points clouds[] = {random.cloud(500, 5.0), random.cloud(500, 5.0)};
  const Points expected[] = {firstOfEachVoxel(clouds[0], 1.0), firstOfEachVoxel(clouds[1], 1.0)};
  VoxelFilter filter;
  Points output;
  for (int call = 0; call < 10; ++call) {
    filter.filter(clouds[call % 2], 1.0, output);
    ASSERT_EQ(output, expected[call % 2]) << call;
  }
}

TEST(VoxelFilter, TellsVoxelsApartFarFromTheOrigin) {
  VoxelFilter filter;
  Points input, output;
  for (const float x : {-65000.f, -64999.f, -1.f, 0.f, 64999.f, 65000.f})
    for (const float y : {-65000.f, 0.f, 65000.f}) input.emplace_back(x, y, -y);
  filter.filter(input, 1.0, output);
  EXPECT_EQ(output, input);
}

TEST(VoxelFilter, SaysWhichPointsItKeeps) {
  const Points input = RandomNumbers(4).cloud(3000, 5.0);
  VoxelFilter filter;
  Points output;
  const auto hold = [&](const VoxelFilter::Indices& kept) {
    ASSERT_EQ(kept.size(), output.size());
    for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(output[i], input[kept[i]]) << i;
  };
  hold(filter.filter(input, 1.0, output));
  EXPECT_LT(output.size(), input.size());
  hold(filter.filterSpread(input, 1.0, output));
}

TEST(VoxelFilter, FiltersInTwoSteps) {
  RandomNumbers random(3);
  VoxelFilter filter;
  Points fine, coarse;
  filter.filter(random.cloud(20000, 5.0), 0.5, fine);
  filter.filter(fine, 1.5, coarse);
  EXPECT_LT(coarse.size(), fine.size());
  EXPECT_EQ(coarse, firstOfEachVoxel(fine, 1.5));
}

}  // namespace
}  // namespace revisit_slam
