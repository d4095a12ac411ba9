// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "datasets/dataset_writers.h"
#include "datasets/simulated_scans.h"
#include "revisit_slam/datasets/open_dataset.h"

namespace revisit_slam {
namespace {

TEST(Apollo, CloudsAreTakenAsDeskewed) {
  const TemporaryFolder folder;
  const auto simulated = simulatedScans("spinning-64", 100);
  writeApollo(folder, simulated);
  const auto scans = openDataset("apollo", folder.file(""));
  ASSERT_EQ(scans->size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    expectWithoutTimes(scans->read(i), simulated[i].scan.points, simulated[i].scan.stamp);
}

TEST(Apollo, ScansAreInTheOrderOfTheirNumbers) {
  const TemporaryFolder folder;
  std::vector<SimulatedScan> simulated = simulatedScans("spinning-16", 50);
  for (int i = 0; i < 8; ++i) {
    simulated.push_back(simulated.back());
    simulated.back().scan.stamp = simulated.back().scan.stamp.plusSeconds(0.1);
  }
  writeApollo(folder, simulated);
  const auto scans = openDataset("apollo", folder.file(""));
  ASSERT_EQ(scans->size(), 11u);
  for (std::size_t i = 1; i < scans->size(); ++i)
    EXPECT_LT(scans->file(i - 1).stamp, scans->file(i).stamp) << i;
}

TEST(Apollo, GroundTruthIsThatOfTheFile) {
  const TemporaryFolder folder;
  const auto simulated = simulatedScans("spinning-16", 50);
  writeApollo(folder, simulated);
  const auto truth = openDataset("apollo", folder.file(""))->groundTruth();
  ASSERT_TRUE(truth);
  ASSERT_EQ(truth->size(), 3u);
  EXPECT_EQ((*truth)[1].stamp, simulated[1].scan.stamp);
  expectPose((*truth)[1].T_world_base, {Eigen::Quaterniond(0.8, 0, 0, 0.6), {2, 0, 0}});
}

}  // namespace
}  // namespace revisit_slam
