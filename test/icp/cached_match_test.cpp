// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/cached_match.h"

#include <gtest/gtest.h>

#include "support/room_map.h"

namespace revisit_slam {
namespace {

/// A point that moves about a place in the room, by less and by more than neighbours are apart.
TEST(CachedMatch, IsAlwaysWhatASearchOfTheMapFinds) {
  const LocalVoxelMap map = mapOfRoom(0.02);
  const Points points = everyFifth(map.points());
  RandomNumbers random(1);
  for (const double step : {0.01, 0.1, 1.0}) {
    CachedMatch match;
    const Eigen::Vector3d place = points[points.size() / 2].cast<double>();
    int found = 0;
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d p = place + random.inCube(step);
      const double reach = i % 3 == 0 ? 0.1 : 0.5;
      Neighbour expected;
      const bool is_near = map.nearest(p, reach, expected);
      ASSERT_EQ(match.update(p, map, reach), is_near) << i;
      if (!is_near) continue;
      ASSERT_EQ(match.neighbour().point_odom, expected.point_odom) << i;
      ++found;
    }
    EXPECT_GT(found, 20) << step;
  }
}

}  // namespace
}  // namespace revisit_slam
