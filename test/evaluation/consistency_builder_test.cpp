// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/consistency_builder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/evaluation_fixtures.h"
#include "support/synthetic_street.h"

namespace revisit_slam {
namespace {

constexpr double kLength = 60.0, kStep = 2.0;

/// There and back along the street with a stop at its end.
class StreetDrive {
 public:
  StreetDrive() {
    for (double x = 0.0; x <= kLength; x += kStep) add(x, 0.4);
    turn_ = truth_.size();
    for (int i = 0; i < 40; ++i) add(kLength, 0.9);
    for (double x = kLength; x >= 0.0; x -= kStep) add(x, 0.4);
    SyntheticStreet street(1, 2, kLength);
    for (const StampedPose& pose : truth_) scans_.push_back(street.scan(pose.T_world_base));
  }

  const Trajectory& truth() const { return truth_; }

  /// The way back is shifted across the street.
  Trajectory shifted(double metres) const {
    Trajectory estimate = truth_;
    for (std::size_t i = turn_; i < estimate.size(); ++i)
      estimate[i].T_world_base.translation.y() += metres;
    return estimate;
  }

  MapConsistency judge(const Trajectory& estimate, const ConsistencyConfig& config = {}) const {
    ConsistencyBuilder builder(findRevisits(truth_, config), config);
    for (std::size_t i = 0; i < scans_.size(); ++i)
      builder.insert(estimate[i].stamp, scans_[i], estimate[i].T_world_base);
    return builder.finish();
  }

 private:
  void add(double x, double seconds) {
    const Stamp stamp = truth_.empty() ? stampOf(0) : truth_.back().stamp.plusSeconds(seconds);
    truth_.push_back({stamp, poseAt(x, 0.0)});
  }

  Trajectory truth_;
  std::vector<Points> scans_;
  std::size_t turn_ = 0;
};

const StreetDrive& street() {
  static const StreetDrive drive;
  return drive;
}

TEST(Consistency, OfTruePosesIsAboutNoiseAndVoxels) {
  const MapConsistency result = street().judge(street().truth());
  ASSERT_GE(result.cells.size(), 3u);
  EXPECT_EQ(result.cells_without_pairs, 0u);
  EXPECT_GT(result.of_cells.mean, 0.02);  // the noise of the scans
  EXPECT_LT(result.of_cells.mean, 0.5 * ConsistencyConfig{}.voxel_size);
  EXPECT_LT(result.of_cells.standard_deviation, 0.3 * result.of_cells.mean);
  EXPECT_GT(result.share, 0.98);
}

TEST(Consistency, GrowsWithMisalignment) {
  double previous = 0.0;
  for (const double metres : {0.0, 0.05, 0.1, 0.2, 0.4, 0.8}) {
    const double mean = street().judge(street().shifted(metres)).of_cells.mean;
    EXPECT_GT(mean, 1.02 * previous) << metres;
    previous = mean;
  }
}

TEST(Consistency, MeasuresTheThicknessOfSurfacesInAllCells) {
  ConsistencyConfig config;
  config.kept_cells = 100;
  const MapConsistency result = street().judge(street().shifted(0.2), config);
  PlaneThickness expected;
  for (const CellMaps& cell : result.worst)
    expected += planeThickness(cell.maps, config.thickness_edge);
  EXPECT_GT(expected.points, 1000u);
  EXPECT_EQ(result.thickness.points, expected.points);
  EXPECT_NEAR(result.thickness.rms(), expected.rms(), 1e-9);
}

TEST(Consistency, OfMapsFarApartHasFewPairs) {
  const MapConsistency near = street().judge(street().shifted(0.2));
  const MapConsistency far = street().judge(street().shifted(15.0));
  EXPECT_LT(far.share, 0.8 * near.share);
}

TEST(Consistency, IsUnchangedByARigidMotionOfTheWholeEstimate) {
  RandomNumbers random(3);
  const Trajectory estimate = street().shifted(0.1);
  const MapConsistency here = street().judge(estimate);
  const MapConsistency there = street().judge(moved(random.pose(500.0), estimate));
  ASSERT_EQ(here.cells.size(), there.cells.size());
  EXPECT_NEAR(here.of_cells.mean, there.of_cells.mean, 1e-4 * here.of_cells.mean);
  EXPECT_NEAR(here.share, there.share, 1e-4);
}

TEST(Consistency, FindsRevisitsOnTheEstimateItself) {
  const ConsistencyConfig config;
  const Trajectory estimate = street().shifted(0.3);
  EXPECT_EQ(findRevisits(estimate, config).size(), findRevisits(street().truth(), config).size());
}

TEST(Consistency, KeepsTheMapsOfTheWorstCells) {
  ConsistencyConfig config;
  config.kept_cells = 2;
  const MapConsistency result = street().judge(street().shifted(0.2), config);
  ASSERT_EQ(result.worst.size(), 2u);
  double largest = 0.0;
  for (const CellConsistency& cell : result.cells)
    largest = std::max(largest, cell.distances.rms());
  const CellMaps& worst = result.worst.front();
  ASSERT_EQ(worst.maps.size(), 2u);
  EXPECT_EQ(nearestDistances(worst.maps[0], worst.maps[1], config.max_distance).rms(), largest);
}

TEST(Consistency, WithoutScansIsUnknown) {
  const ConsistencyConfig config;
  ConsistencyBuilder builder(findRevisits(street().truth(), config), config);
  const MapConsistency result = builder.finish();
  EXPECT_TRUE(result.cells.empty());
  EXPECT_GE(result.cells_without_pairs, 3u);
  EXPECT_TRUE(std::isnan(result.of_cells.mean));
}

TEST(Consistency, WantsOnlyScansOfRevisitedPlaces) {
  const ConsistencyConfig config;
  Trajectory truth = street().truth();
  for (int i = 1; i < 100; ++i)
    truth.push_back({truth.back().stamp.plusSeconds(0.2), poseAt(-1.0 * i, 0.0)});
  const ConsistencyBuilder builder(findRevisits(truth, config), config);
  EXPECT_TRUE(builder.wants(truth[5].stamp));
  EXPECT_FALSE(builder.wants(truth.back().stamp));
  EXPECT_FALSE(builder.wants(truth.front().stamp.plusSeconds(-1.0)));
}

}  // namespace
}  // namespace revisit_slam
