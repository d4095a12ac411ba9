// SPDX-License-Identifier: MIT
// What rviz gets: clouds, markers, the density image and the path.
#include "revisit_slam/ros/messages/display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "revisit_slam/ros/messages/coloured_cloud.h"
#include "revisit_slam/ros/messages/density_message.h"
#include "revisit_slam/ros/messages/loop_markers.h"
#include "revisit_slam/ros/messages/map_markers.h"
#include "revisit_slam/ros/messages/path_message.h"

namespace revisit_slam {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

Pose at(double x, double y) {
  return {Eigen::Quaterniond::Identity(), {x, y, 0.0}};
}

float coordinate(const sensor_msgs::PointCloud2& cloud, std::size_t point, std::size_t field) {
  float value;
  std::memcpy(&value, &cloud.data[point * cloud.point_step + cloud.fields[field].offset], 4);
  return value;
}

int countOf(const MarkerArray& array, const std::string& ns) {
  int count = 0;
  for (const Marker& marker : array.markers) count += marker.ns == ns;
  return count;
}

/// Scans 10 m apart along x.
SlamGraph straightDrive(std::uint32_t scans) {
  SlamGraph graph{BackEndConfig{}};
  for (std::uint32_t i = 0; i < scans; ++i)
    graph.add({ScanId{i}, Stamp{100'000'000 * (i + 1)}, at(10.0 * i, 0.0), Matrix6::Identity()});
  return graph;
}

TEST(Display, coloursOfTheFirstIdsDiffer) {
  std::set<std::tuple<int, int, int>> colours;
  for (std::uint32_t id = 0; id < 30; ++id) {
    const auto c = colourOf(id);
    colours.insert({int(255 * c.r) / 8, int(255 * c.g) / 8, int(255 * c.b) / 8});
  }
  EXPECT_GE(colours.size(), 25u);
}

TEST(ColouredCloud, placesAndColoursEveryPart) {
  const Points a{{1, 2, 3}}, b{{0, 0, 0}, {4, 0, 0}};
  const auto cloud = toColouredCloud(
      {{&a, at(10, 0), colour(1, 0, 0)}, {&b, at(0, 5), colour(0, 0, 1)}}, "map", 99);
  ASSERT_EQ(cloud.width, 3u);
  ASSERT_EQ(cloud.data.size(), 3u * cloud.point_step);
  EXPECT_EQ(coordinate(cloud, 0, 0), 11.0f);
  EXPECT_EQ(coordinate(cloud, 0, 2), 3.0f);
  EXPECT_EQ(coordinate(cloud, 2, 0), 4.0f);
  EXPECT_EQ(coordinate(cloud, 2, 1), 5.0f);
  std::uint32_t rgb;
  std::memcpy(&rgb, &cloud.data[cloud.fields[3].offset], 4);
  EXPECT_EQ(rgb, 0xff0000u);
}

TEST(ColouredCloud, picksAsManyPointsAsItMayEvenly) {
  Points many;
  for (int i = 0; i < 1000; ++i) many.emplace_back(i, 0, 0);
  const Points first(many.begin(), many.begin() + 300), rest(many.begin() + 300, many.end());
  for (const int most : {1, 99, 500, 999, 1000, 2000}) {
    const auto cloud = toColouredCloud(
        {{&first, at(0, 0), colour(1, 1, 1)}, {&rest, at(0, 0), colour(1, 1, 1)}}, "map", most);
    ASSERT_EQ(static_cast<int>(cloud.width), std::min(most, 1000));
    const float step = 1000.0f / static_cast<float>(cloud.width);
    for (std::size_t i = 1; i < cloud.width; ++i)
      ASSERT_NEAR(coordinate(cloud, i, 0) - coordinate(cloud, i - 1, 0), step, 1.0f);
  }
}

TEST(MapMarkers, boxesAreAroundThePointsWhereTheMapIsPlaced) {
  auto submap = std::make_shared<Submap>();
  auto map = std::make_shared<LocalMap>();
  map->submaps = {submap};
  map->points = {{-1, -2, 0}, {3, 4, 9}};
  const MarkerArray array = toOutlines({map}, {at(100, 0)}, "map");
  ASSERT_EQ(countOf(array, "outlines"), 1);
  const Marker& box = array.markers[1];
  ASSERT_EQ(box.points.size(), 5u);
  EXPECT_EQ(box.points[0].x, 99.0);
  EXPECT_EQ(box.points[0].y, -2.0);
  EXPECT_EQ(box.points[2].x, 103.0);
  EXPECT_EQ(box.points[2].y, 4.0);
  const MarkerArray keyposes = toKeyposes({submap}, {at(7, 8)}, "map");
  EXPECT_EQ(keyposes.markers.back().points.at(0).y, 8.0);
}

TEST(LoopMarkers, statesHaveTheirColours) {
  SlamGraph graph = straightDrive(4);
  LoopConstraint loop;
  loop.constraint = {ScanId{0}, ScanId{3}, at(30.0, 0.0), Matrix6::Identity()};
  ASSERT_TRUE(graph.optimise(ScanId{3}, {loop}));
  const auto colourOfFirst = [&] {
    for (const Marker& marker : toLoopEdges(graph, 0.1, "map").markers)
      if (marker.type == Marker::LINE_LIST) return marker.colors.at(0);
    return std_msgs::ColorRGBA();
  };
  const auto textOfFirst = [&] {
    for (const Marker& marker : toLoopEdges(graph, 0.1, "map").markers)
      if (marker.type == Marker::TEXT_VIEW_FACING) return marker.text;
    return std::string();
  };
  EXPECT_GT(colourOfFirst().r, 0.9f);
  EXPECT_EQ(colourOfFirst().g, 0.0f);
  EXPECT_EQ(textOfFirst(), "0");
  ASSERT_TRUE(graph.disable(LoopId{0}));
  EXPECT_EQ(colourOfFirst().r, colourOfFirst().g);
  EXPECT_EQ(textOfFirst(), "0 disabled");
}

TEST(LoopMarkers, noMapHasTheColourOfALoop) {
  for (std::uint32_t id = 0; id < 200; ++id) {
    const auto c = colourOf(id);
    EXPECT_GT(std::min({c.r, c.g, c.b}), 0.2f) << id;  // the colours of loops are full: one is 0
  }
}

TEST(LoopMarkers, rejectedPairsSayWhy) {
  LoopSearchResult search;
  search.candidates.resize(1);
  search.candidates[0].inliers = 4;
  search.proposals.resize(2);
  search.proposals[1].verdict = {"fitness", {0.18, Bound::above, 0.25, ""}};
  const auto anywhere = [](auto) { return at(0, 0); };
  std::multiset<std::string> texts;
  for (const Marker& marker : toLoopCandidates({search}, anywhere, anywhere, "map").markers)
    if (marker.type == Marker::TEXT_VIEW_FACING) texts.insert(marker.text);
  EXPECT_EQ(texts, (std::multiset<std::string>{"4", "fitness 0.18 <= 0.25"}));
}

TEST(DensityMessage, hasYUpwardsAndMarksFeatures) {
  PlaceView view;
  view.image = {3, 2, 0.5, Pixel(10, 20), {255, 0, 0, 0, 0, 0}};  // row 0: the smallest y
  const auto plain = toDensityMessage(view);
  ASSERT_EQ(plain.width, 6u);
  ASSERT_EQ(plain.height, 4u);
  EXPECT_EQ(plain.data[3 * plain.step], 255);  // bottom left
  EXPECT_EQ(plain.data[0], 0);                 // top left
  view.features.keypoints.push_back({12, 21, 0.0f});
  EXPECT_NE(toDensityMessage(view).data, plain.data);
}

TEST(DensityMessage, emptyImageStaysEmpty) {
  EXPECT_EQ(toDensityMessage({}).width, 0u);
}

TEST(Path, isThinnedAndKeepsBothEnds) {
  const SlamGraph graph = straightDrive(1000);
  const nav_msgs::Path path = toPath(graph, 0, "map", 100);
  EXPECT_LE(path.poses.size(), 101u);
  EXPECT_GE(path.poses.size(), 80u);
  EXPECT_EQ(path.poses.front().pose.position.x, 0.0);
  EXPECT_EQ(path.poses.back().pose.position.x, 9990.0);
  EXPECT_EQ(toPath(straightDrive(5), 0, "map", 100).poses.size(), 5u);
  EXPECT_TRUE(toPath(straightDrive(0), 0, "map", 100).poses.empty());
}

}  // namespace
}  // namespace revisit_slam
