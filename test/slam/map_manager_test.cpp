// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/map_manager.h"

#include <gtest/gtest.h>

#include "support/synthetic_street.h"

namespace revisit_slam {
namespace {

constexpr SessionId kFirst{3}, kSecond{4};

/// A lane whose tasks are done when the test says so.
class HeldLane : public Lane {
 public:
  void post(Task task) override { tasks_.push_back(std::move(task)); }
  void drain() override {
    while (!tasks_.empty()) {
      const Task task = std::move(tasks_.front());
      tasks_.pop_front();
      task();
    }
  }
  void discard() override { tasks_.clear(); }
  std::size_t waiting() const override { return tasks_.size(); }

 private:
  std::deque<Task> tasks_;
};

class MapManagerTest : public testing::Test {
 protected:
  MapManagerTest() { config_.loops.recognition.min_inliers = 10000; }

  MapManager::Outputs outputs() {
    MapManager::Outputs outputs;
    outputs.maps = [this](const MapUpdatePtr& maps) { maps_.push_back(maps); };
    outputs.session = [this](SessionId session, const KnownMapPtr&) {
      sessions_.push_back(session);
    };
    outputs.loops.search = [this](const LoopSearchResult& search) { searches_.push_back(search); };
    outputs.loops.closures = [this](const LoopClosures& closures) {
      closures_.push_back(closures);
    };
    outputs.loops.closed = [this](const MapsClosed& closed) { closed_.push_back(closed); };
    outputs.loops.problem = [](const std::string& problem) { FAIL() << problem; };
    return outputs;
  }

  InformedScan scan(std::uint32_t number, double x, SessionId session = kFirst) {
    auto scan = std::make_shared<RegisteredScan>();
    scan->id = {number, session};
    scan->stamp = Stamp::fromSeconds(number);
    scan->T_odom_base = poseAt(x, 0);
    scan->points_base = street_.scan(scan->T_odom_base);
    InformedScan informed;
    informed.scan = scan;
    return informed;
  }

  /// `metres` along the street, 5 m a scan.
  void drive(MapManager& manager, double metres, SessionId session = kFirst) {
    for (std::uint32_t i = 0; 5.0 * i <= metres; ++i) manager.insert(scan(i, 5.0 * i, session));
  }

  SlamConfig config_;
  SyntheticStreet street_{5, 1};
  std::vector<MapUpdatePtr> maps_;
  std::vector<SessionId> sessions_;
  std::vector<LoopSearchResult> searches_;
  std::vector<LoopClosures> closures_;
  std::vector<MapsClosed> closed_;
};

TEST_F(MapManagerTest, closesMapsAndSearchesEachOnce) {
  InlineLane building, searching;
  MapManager manager(config_, building, searching, outputs());
  drive(manager, 60.0);
  manager.close(9);
  ASSERT_EQ(maps_.size(), 3u);  // 25 m each, the last of them open until the end
  EXPECT_TRUE(maps_.back()->local_map);
  ASSERT_EQ(closures_.size(), 2u);  // by appearance and within the window, both without loops
  EXPECT_EQ(closures_[0].map, (LocalMapId{0, kFirst}));
  EXPECT_EQ(closures_[0].last_scan, (ScanId{12, kFirst}));
  EXPECT_EQ(closures_[0].request, 0u);
  ASSERT_EQ(closed_.size(), 1u);
  EXPECT_EQ(closed_[0].request, 9u);
  EXPECT_EQ(closed_[0].scans, 13u);
}

TEST_F(MapManagerTest, inRoomsMapsAreSmallerAsTheVoxelsOfTheOdometryAre) {
  config_.odometry.map.voxel_size = 1.0;
  const auto submapsWith = [&](double voxel_size) {
    maps_.clear();
    InlineLane building, searching;
    MapManager manager(config_, building, searching, outputs());
    for (std::uint32_t i = 0; i < 10; ++i) {
      InformedScan informed = scan(i, 5.0 * i);
      auto registered = std::make_shared<RegisteredScan>(*informed.scan);
      registered->voxel_size = voxel_size;
      informed.scan = registered;
      manager.insert(informed);
    }
    manager.close(1);
    return maps_.size();
  };
  EXPECT_EQ(submapsWith(1.0), 2u);
  EXPECT_EQ(submapsWith(0.5), 4u);
  EXPECT_EQ(maps_.back()->submap->scale, 1.0);
  EXPECT_GT(submapsWith(0.25), 4u);
  EXPECT_EQ(maps_.back()->submap->scale, 0.5);
  config_.mapping.follow_scale = false;
  EXPECT_EQ(submapsWith(0.25), 2u);
  EXPECT_EQ(maps_.back()->submap->scale, 1.0);
}

TEST_F(MapManagerTest, whereScansHardlyHoldThePoseTheDistanceIsUnsure) {
  InlineLane building, searching;
  MapManager manager(config_, building, searching, outputs());
  for (std::uint32_t i = 0; i < 12; ++i) {
    InformedScan informed = scan(i, 5.0 * i);
    Tangent along = Tangent::Zero();
    along(0) = 0.8, along(2) = 0.6;
    if (i >= 2 && i < 4) informed.estimate.weak_directions = {{along, 0.0}};
    informed.covariance_motion = 12.0 * Matrix6::Identity();
    if (i == 4) informed.verdict = PoseVerdict::lost;
    manager.insert(informed);
  }
  manager.close(1);
  ASSERT_GE(maps_.size(), 2u);
  EXPECT_EQ(maps_[0]->submap->unsure_begin.weak, 0.0);
  EXPECT_NEAR(maps_[1]->submap->unsure_begin.weak, 0.8 * 10.0 + 5.0, 1e-9);
  EXPECT_NEAR(maps_[1]->submap->unsure_begin.weak_height, 0.6 * 10.0 + 5.0, 1e-9);
  EXPECT_NEAR(maps_[1]->submap->unsure_begin.doubt, 6.0, 1e-9);
}

TEST_F(MapManagerTest, aLostTrackBeginsANewLocalMap) {
  InlineLane building, searching;
  MapManager manager(config_, building, searching, outputs());
  for (std::uint32_t i = 0; i < 6; ++i) {
    const InformedScan informed = scan(i, 5.0 * i);
    auto lost = std::make_shared<RegisteredScan>(*informed.scan);
    if (i == 3) lost->verdict = PoseVerdict::lost;
    InformedScan judged = informed;
    judged.scan = lost;
    judged.verdict = lost->verdict;
    manager.insert(judged);
  }
  manager.close(1);
  ASSERT_EQ(maps_.size(), 2u);
  ASSERT_TRUE(maps_[0]->local_map && maps_[1]->local_map);
  EXPECT_EQ(maps_[1]->submap->first_scan.value, 3u);
  EXPECT_TRUE(maps_[1]->local_map->after_loss);
}

TEST_F(MapManagerTest, aNewSessionClosesTheMapsOfTheOneBefore) {
  InlineLane building, searching;
  MapManager manager(config_, building, searching, outputs());
  drive(manager, 30.0, kFirst);
  drive(manager, 30.0, kSecond);
  manager.close(1);
  EXPECT_EQ(sessions_, (std::vector<SessionId>{kFirst, kSecond}));
  ASSERT_EQ(closed_.size(), 2u);
  EXPECT_EQ(closed_[0].session, kFirst);
  EXPECT_EQ(closed_[0].request, 0u);
  EXPECT_EQ(closed_[1].session, kSecond);
  EXPECT_EQ(maps_.front()->submap->id, (SubmapId{0, kFirst}));
  EXPECT_EQ(maps_.back()->submap->id.session, kSecond);
}

TEST_F(MapManagerTest, scansAfterAGapAreCountedAndOfNoUse) {
  InlineLane building, searching;
  MapManager manager(config_, building, searching, outputs());
  manager.insert(scan(0, 0.0));
  manager.insert(scan(2, 5.0));
  manager.close(1);
  EXPECT_EQ(manager.count().missed_scans, 1);
  EXPECT_EQ(closed_.front().scans, 1u);
}

TEST_F(MapManagerTest, aBaseThatRestsAddsNothing) {
  InlineLane building, searching;
  MapManager manager(config_, building, searching, outputs());
  manager.insert(scan(0, 0.0));
  for (int i = 0; i < 3; ++i) manager.insert(scan(0, 0.0));
  manager.close(1);
  EXPECT_EQ(manager.count().missed_scans, 0);
  EXPECT_EQ(closed_.front().scans, 1u);
  EXPECT_EQ(maps_.front()->submap->stamps.size(), 1u);
}

TEST_F(MapManagerTest, whatWaitsIsBoundedAndNoScanIsMissingInTheTrajectory) {
  config_.mapping.max_waiting = 4;
  HeldLane building;
  InlineLane searching;
  MapManager manager(config_, building, searching, outputs());
  std::vector<std::weak_ptr<const RegisteredScan>> held;
  for (std::uint32_t i = 0; i < 10; ++i) {
    const InformedScan whole = scan(i, 2.0 * i);
    held.push_back(whole.scan);
    manager.insert(whole);
  }
  std::size_t whole = 0;
  for (const auto& scan : held) whole += scan.expired() ? 0 : 1;
  EXPECT_EQ(whole, 5u);
  EXPECT_EQ(manager.count().thinned_scans, 5);
  building.drain();
  manager.close(1);
  building.drain();
  EXPECT_EQ(maps_.back()->submap->T_submap_scan.size(), 10u);
}

}  // namespace
}  // namespace revisit_slam
