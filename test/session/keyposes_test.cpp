// SPDX-License-Identifier: MIT
#include "revisit_slam/session/keyposes.h"

#include <gtest/gtest.h>

#include "session/session_fixtures.h"
#include "support/random_numbers.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

class KeyposesTest : public testing::Test {
 protected:
  KeyposesTest() {
    writeStreetSession(folder_.file("a"));
    std::vector<std::string> notices;
    session_ = readSession(folder_.file("a"), notices);
    const SessionOffsets<ScanId> scans = scansOf(session_.graph);
    for (const SubmapClosed& submap : session_.submaps)
      keyposes_.push_back(session_.graph.T_map_scan[scans[submap.first_scan]]);
  }

  TemporaryFolder folder_;
  Session session_;
  std::vector<Pose> keyposes_;
};

TEST_F(KeyposesTest, AreReadToTheLastBit) {
  RandomNumbers random(1);
  std::vector<Pose> poses(20);
  for (Pose& pose : poses) pose = random.pose(1e4);
  const std::vector<Pose> read = readKeyposes(folder_.with("k.csv", keyposeText(poses)));
  ASSERT_EQ(read.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(read[i].translation, poses[i].translation);
    EXPECT_EQ(read[i].rotation.coeffs(), poses[i].rotation.coeffs());
  }
  for (const char* line : {"20,1,x", "20,0,0,0,1,5,6", "20,0,0,0,1,5,6,7,8", "20,0,0,0,0,5,6,7",
                           "20,0,0,0,1,nan,6,7", "20,0,0,0,1,1e12,6,7"})
    EXPECT_THROW(readKeyposes(folder_.with("k.csv", keyposeText(poses) + line + "\n")),
                 std::runtime_error)
        << line;
}

TEST_F(KeyposesTest, TheSameKeyposesMoveNothing) {
  const std::vector<Pose> before = session_.graph.T_map_scan;
  moveToKeyposes(keyposes_, session_);
  ASSERT_EQ(session_.graph.T_map_scan.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT(distanceBetween(session_.graph.T_map_scan[i], before[i]), 1e-9) << i;
}

TEST_F(KeyposesTest, TheMapStaysWhereItIsOnTheEarth) {
  session_.graph.georeference.emplace();
  session_.graph.georeference->T_enu_map = {expSO3({0.0, 0.0, 0.5}), {10.0, 20.0, 30.0}};
  const Pose T_enu_first =
      session_.graph.georeference->T_enu_map * session_.graph.T_map_scan.front();
  for (Pose& pose : keyposes_) pose = Pose{expSO3({0.0, 0.0, 1.0}), {100.0, -50.0, 3.0}} * pose;
  moveToKeyposes(keyposes_, session_);
  EXPECT_LT(
      distanceBetween(session_.graph.georeference->T_enu_map * session_.graph.T_map_scan.front(),
                      T_enu_first),
      1e-9);
}

/// The map as a whole moves, and the last keypose by 0.2 m more: scans between move by more and
/// more.
TEST_F(KeyposesTest, ScansBetweenTakeTheirShare) {
  const std::vector<Pose> before = session_.graph.T_map_scan;
  const Pose T_new_map{expSO3({0.0, 0.0, 1.0}), {100.0, -50.0, 3.0}};
  ASSERT_GT(keyposes_.size(), 1u);
  for (Pose& pose : keyposes_) pose = T_new_map * pose;
  keyposes_.back() = keyposes_.back() * Pose{Eigen::Quaterniond::Identity(), {0.2, 0.0, 0.0}};
  moveToKeyposes(keyposes_, session_);
  double last = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double moved =
        (session_.graph.T_map_scan[i].translation - (T_new_map * before[i]).translation).norm();
    EXPECT_GE(moved, last - 0.02) << i;
    last = moved;
  }
  EXPECT_NEAR(last, 0.2, 1e-6);
}

TEST_F(KeyposesTest, OfAnotherSessionAreRefused) {
  keyposes_.pop_back();
  EXPECT_THROW(moveToKeyposes(keyposes_, session_), std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
