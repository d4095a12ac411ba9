// SPDX-License-Identifier: MIT
#include "revisit_slam/session/stored_local_map.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/street_revisit.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(StoredLocalMap, IsReadAsPlaceRecognitionComparesIt) {
  const TemporaryFolder folder;
  const LocalMapPtr map = streetRevisit().back();
  PlaceView view = viewPlace(*map, {});
  view.features.keypoints = {{3, -4, 0.5f}, {-300, 200, -1.0f}};
  view.features.descriptors = {{1, 2, 3, ~std::uint64_t{0}}, {5, 6, 7, 8}};
  const StoredLocalMap stored = storedLocalMap(*map, &view);
  const StoredLocalMap read = readLocalMap(folder.with("0002.rsm", encodeLocalMap(stored)));
  EXPECT_EQ(read.id, map->id);
  ASSERT_EQ(read.submaps.size(), map->submaps.size());
  EXPECT_EQ(read.submaps.back(), map->submaps.back()->id);
  EXPECT_EQ(read.T_level_local.translation, view.T_level_local.translation);
  EXPECT_EQ(read.features.descriptors, view.features.descriptors);
  EXPECT_EQ(encodeLocalMap(read), encodeLocalMap(stored));
  StoredLocalMap undirected = stored;
  undirected.features.keypoints[1].angle = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(readLocalMap(folder.with("nan.rsm", encodeLocalMap(undirected))),
               std::runtime_error);
  EXPECT_THROW(readLocalMap(folder.with("cut.rsm", encodeLocalMap(stored).substr(0, 90))),
               std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
