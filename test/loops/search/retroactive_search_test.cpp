// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/search/retroactive_search.h"

#include <gtest/gtest.h>

#include <memory>

namespace revisit_slam {
namespace {

/// Five local maps along x, 100 m each in four submaps, then back along them, `aside` metres away:
/// 9 lies on 0, 8 on 1 and so on.
class RetroactiveSearchTest : public testing::Test {
 protected:
  explicit RetroactiveSearchTest(double aside = 6.0) {
    for (unsigned n = 0; n < 10; ++n) {
      const double step = n < 5 ? 1.0 : -1.0;
      auto map = std::make_shared<LocalMap>();
      map->id = {n};
      for (unsigned k = 0; k < 4; ++k) map->submaps.push_back(submap(100 * n + 25 * k, step));
      maps_.push_back(map);
      for (int m = 0; m < 100; ++m)
        T_map_scan_.push_back({Eigen::Quaterniond::Identity(),
                               n < 5 ? Eigen::Vector3d(100.0 * n + m, 0, 0)
                                     : Eigen::Vector3d(100.0 * (10 - n) - m, aside, 0)});
    }
  }

  static SubmapPtr submap(unsigned first_scan, double step) {
    auto submap = std::make_shared<Submap>();
    submap->first_scan = {first_scan};
    submap->travelled_begin = first_scan;
    submap->travelled_end = first_scan + 24.0;
    submap->T_submap_scan.resize(25);
    for (int m = 0; m < 25; ++m) submap->T_submap_scan[m].translation.x() = step * m;
    return submap;
  }

  std::vector<RetroactiveCandidate> search(std::optional<LocalMapId> p, unsigned n,
                                           const std::set<LocalMapPair>& closed = {}) const {
    RetroactiveConfig config;
    config.association.min_detour = 6.0;  // the last map ahead and the first one back: neighbours
    return RetroactiveSearch(config).search(maps_, T_map_scan_, p, {n}, closed);
  }

  std::vector<LocalMapPtr> maps_;
  std::vector<Pose> T_map_scan_;
};

bool contains(const std::vector<RetroactiveCandidate>& candidates, unsigned i, unsigned j) {
  for (const RetroactiveCandidate& candidate : candidates)
    if (candidate.maps == LocalMapPair{{i}, {j}}) return true;
  return false;
}

TEST_F(RetroactiveSearchTest, FindsMissedLoops) {
  const auto candidates = search({}, 9, {{{9}, {0}}});
  for (unsigned i = 6; i < 9; ++i) EXPECT_TRUE(contains(candidates, i, 9 - i));
  EXPECT_FALSE(contains(candidates, 9, 0));  // closed
  EXPECT_FALSE(contains(candidates, 5, 4));  // neighbours
  EXPECT_FALSE(contains(candidates, 9, 3));  // far apart
}

TEST_F(RetroactiveSearchTest, RecomputesTrajectoriesFromTheGraphWhereItIsAsked) {
  AssociationConfig config;
  EXPECT_TRUE(placeByGraph(*maps_[7], T_map_scan_, config).at(0).T_common_scan.empty());
  config.trajectories = "optimised";
  const PlacedSubmap placed = placeByGraph(*maps_[7], T_map_scan_, config).at(0);
  ASSERT_EQ(placed.T_common_scan.size(), 25u);
  EXPECT_EQ(placed.T_common_submap.translation, T_map_scan_[700].translation);
  EXPECT_EQ(placed.T_common_scan.back().translation, T_map_scan_[724].translation);
}

TEST_F(RetroactiveSearchTest, LooksOnlyBetweenTheClosures) {
  for (const RetroactiveCandidate& candidate : search(LocalMapId{6}, 8)) {
    EXPECT_GT(candidate.maps.first.value, 6u);
    EXPECT_LE(candidate.maps.first.value, 8u);
    EXPECT_LT(candidate.maps.second.value, candidate.maps.first.value);
  }
}

TEST_F(RetroactiveSearchTest, TheBestIsNearAndFarFromOtherClosures) {
  const auto candidates = search({}, 9, {{{9}, {0}}});
  EXPECT_EQ(candidates.front().maps, (LocalMapPair{{6}, {3}}));
  EXPECT_NEAR(candidates.front().hausdorff, std::hypot(6, 1), 1e-9);
  for (std::size_t i = 1; i < candidates.size(); ++i)
    EXPECT_LE(candidates[i].gain, candidates[i - 1].gain);
}

/// Three local maps of one submap each: 60 m ahead, 60 m on around a bend, and back beside the
/// first.
TEST(RetroactiveSearch, NeighboursMeetAgainWhereTheTravelledDistanceBetweenTheirSubmapsIsLong) {
  const Eigen::Vector3d corners[] = {{0, 0, 0}, {60, 0, 0}, {60, 5, 0}, {0, 5, 0}};
  std::vector<SubmapPtr> submaps;
  std::vector<Pose> T_map_scan;
  for (unsigned n = 0; n < 3; ++n) {
    auto submap = std::make_shared<Submap>();
    submap->first_scan = {60 * n};
    const Eigen::Vector3d step = (corners[n + 1] - corners[n]) / 60.0;
    submap->travelled_begin = n == 0 ? 0.0 : submaps.back()->travelled_end;
    submap->travelled_end =
        submap->travelled_begin + (n == 1 ? 240.0 : 60.0);  // the bend is longer than it looks
    submap->T_submap_scan.resize(60);
    for (int m = 0; m < 60; ++m) {
      submap->T_submap_scan[m].translation = m * step;
      T_map_scan.push_back({Eigen::Quaterniond::Identity(), corners[n] + m * step});
    }
    submaps.push_back(submap);
  }
  const auto map = [](unsigned id, std::vector<SubmapPtr> parts) {
    return std::make_shared<LocalMap>(LocalMap{{id}, std::move(parts), {}});
  };
  const std::vector<LocalMapPtr> maps{map(0, {submaps[0], submaps[1]}), map(1, {submaps[2]})};
  const auto found = RetroactiveSearch({}).search(maps, T_map_scan, {}, {1}, {});
  EXPECT_TRUE(contains(found, 1, 0));
  RetroactiveConfig config;
  config.association.min_detour = 5.0;  // of the 5 m between them and the 59 m of a submap
  EXPECT_TRUE(RetroactiveSearch(config).search(maps, T_map_scan, {}, {1}, {}).empty());
}

/// Round a block of 60 m and past the start, all in one local map.
TEST(RetroactiveSearch, ALocalMapThatMeetsItselfIsSearched) {
  const Eigen::Vector3d corners[] = {{0, 0, 0}, {60, 0, 0}, {60, 60, 0}, {0, 60, 0}, {0, 0, 0}};
  LocalMap map;
  std::vector<Pose> T_map_scan;
  for (unsigned n = 0; n < 5; ++n) {
    auto submap = std::make_shared<Submap>();
    submap->first_scan = {30 * n};
    submap->travelled_begin = 60.0 * n;
    submap->travelled_end = submap->travelled_begin + 30.0;
    const Eigen::Vector3d step = (corners[(n + 1) % 4] - corners[n % 4]) / 60.0;
    for (int m = 0; m < 30; ++m) {
      submap->T_submap_scan.push_back({Eigen::Quaterniond::Identity(), m * step});
      T_map_scan.push_back({Eigen::Quaterniond::Identity(), corners[n] + m * step});
    }
    map.submaps.push_back(submap);
  }
  const std::vector<LocalMapPtr> maps{std::make_shared<LocalMap>(map)};
  EXPECT_TRUE(contains(RetroactiveSearch({}).search(maps, T_map_scan, {}, {0}, {}), 0, 0));
  RetroactiveConfig config;
  config.within_maps = false;
  EXPECT_TRUE(RetroactiveSearch(config).search(maps, T_map_scan, {}, {0}, {}).empty());
}

TEST_F(RetroactiveSearchTest, InTheLowDriftWindowAreOnlyMapsNotFarBack) {
  const auto within = [&](double window, unsigned n) {
    RetroactiveConfig config;
    config.low_drift_window = window;
    return RetroactiveSearch(config).searchLowDriftWindow(maps_, T_map_scan_, {n}, {});
  };
  EXPECT_TRUE(contains(within(300.0, 6), 6, 3));   // 201 m back
  EXPECT_FALSE(contains(within(300.0, 7), 7, 2));  // 401 m back
  EXPECT_TRUE(contains(within(500.0, 7), 7, 2));
  for (const RetroactiveCandidate& candidate : within(500.0, 7))
    EXPECT_EQ(candidate.maps.first.value, 7u);
  EXPECT_TRUE(within(0.0, 6).empty());
  EXPECT_TRUE(within(300.0, 0).empty());
}

class DriftedSearchTest : public RetroactiveSearchTest {
 protected:
  DriftedSearchTest() : RetroactiveSearchTest(80.0) {}
};

TEST_F(DriftedSearchTest, StreetsFartherThanTheGapAreNoCandidates) {
  EXPECT_FALSE(contains(search({}, 9), 8, 1));
}

}  // namespace
}  // namespace revisit_slam
