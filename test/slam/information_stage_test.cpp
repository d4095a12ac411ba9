// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/information_stage.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "support/synthetic_drive.h"

namespace revisit_slam {
namespace {

/// What the odometry makes of a drive through a room; the last scan gets this verdict.
std::vector<OdometryOutput> outputs(PoseVerdict verdict) {
  SlamConfig config;
  config.odometry = roomConfig();
  OdometryStage odometry(config);
  std::vector<OdometryOutput> outputs;
  for (const Scan& scan : driveInRoom(12).scans) {
    ScanReading reading;
    reading.scan = scan;
    for (auto& result : odometry.process(std::move(reading)))
      outputs.push_back(std::move(result.output));
  }
  auto judged = std::make_shared<RegisteredScan>(*outputs.back().scan);
  judged->verdict = verdict;
  judged->prior_information = 0.25 * Matrix6::Identity();
  outputs.back().scan = judged;
  if (verdict == PoseVerdict::lost) outputs.back().problem = nullptr;
  return outputs;
}

InformedScan lastOf(const std::vector<OdometryOutput>& outputs) {
  InformationStage stage{InformationConfig{}};
  InformedScan informed;
  for (const OdometryOutput& output : outputs) informed = stage.inform(output);
  return informed;
}

TEST(InformationStage, knowsOfALostPoseWhatThePredictionKnows) {
  const InformedScan informed = lastOf(outputs(PoseVerdict::lost));
  EXPECT_EQ(informed.verdict, PoseVerdict::lost);
  EXPECT_EQ(informed.source, InformationSource::predicted);
  EXPECT_TRUE(informed.covariance_motion.isApprox(4.0 * Matrix6::Identity(), 1e-9));
}

TEST(InformationStage, aPoorPoseMayBeOffByAsMuchAsThePrediction) {
  const InformedScan good = lastOf(outputs(PoseVerdict::good));
  const InformedScan poor = lastOf(outputs(PoseVerdict::poor));
  EXPECT_EQ(poor.verdict, PoseVerdict::poor);
  EXPECT_EQ(poor.source, InformationSource::estimated);
  EXPECT_TRUE(
      (poor.covariance_motion - good.covariance_motion).isApprox(4.0 * Matrix6::Identity(), 1e-6));
  // The graph sees the same: information is inverse to the covariance, in the objective's unit.
  const double unit = (poor.estimate.information * poor.covariance_motion)(0, 0);
  EXPECT_TRUE((poor.estimate.information * poor.covariance_motion)
                  .isApprox(unit * Matrix6::Identity(), 1e-6));
  EXPECT_LT(poor.estimate.information(0, 0), 0.01 * good.estimate.information(0, 0));
}

TEST(InformationStage, withoutEstimatesPoorEdgesKeepAnInformation) {
  for (const PoseVerdict verdict : {PoseVerdict::poor, PoseVerdict::lost}) {
    std::vector<OdometryOutput> odometry = outputs(verdict);
    for (OdometryOutput& output : odometry) output.problem = nullptr;  // information switched off
    const InformedScan informed = lastOf(odometry);
    EXPECT_EQ(informed.verdict, verdict);
    EXPECT_GT(informed.estimate.information.diagonal().minCoeff(), 0.0);
  }
}

}  // namespace
}  // namespace revisit_slam
