// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "evaluation/evaluation_fixtures.h"

namespace revisit_slam {
namespace {

std::size_t linesOf(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

EstimateEvaluation withReference() {
  EstimateEvaluation evaluation;
  evaluation.name = "a";
  evaluation.estimate = windingDrive(160);
  evaluation.trajectory = evaluateTrajectory(PoseInterpolator(evaluation.estimate),
                                             PoseInterpolator(straightDrive(150)));
  return evaluation;
}

TEST(Evaluation, TablesHaveAlignedPositionsBesideTheReference) {
  const EstimateEvaluation evaluation = withReference();
  const std::string text = posesCsv(evaluation);
  EXPECT_EQ(linesOf(text), 151u);
  EXPECT_EQ(
      text.find("stamp,x,y,z,reference_x,reference_y,reference_z,error\n1700000000.000000000,"),
      0u);
  EstimateEvaluation alone;
  alone.estimate = windingDrive(3);
  EXPECT_EQ(linesOf(posesCsv(alone)), 4u);
}

TEST(Evaluation, UnknownNumbersAreKeptOutOfTheMeans) {
  RevisitCell place{
      {1, -2}, {20, -40}, {{{{stampOf(0), stampOf(9)}}}, {{{stampOf(500), stampOf(509)}}}}};
  // Three passes of the first place: two pairs of 0.1 m and 0.3 m RMS, one without partners.
  const std::vector<NearestDistances> pairs{{40, 10, 10 * 0.01}, {30, 30, 30 * 0.09}, {30, 0, 0.0}};
  const MapConsistency result =
      summarise({{place, pairs, {100, 50, 50 * 0.04}, {0.2, 10}},
                 {place, {{100, 0, 0.0}}, {100, 0, 0.0}, {}},
                 {place, {{100, 100, 100 * 0.16}}, {100, 100, 100 * 0.16}, {0.1, 20}}},
                {});
  EXPECT_EQ(result.cells.size(), 2u);
  EXPECT_EQ(result.cells_without_pairs, 1u);
  EXPECT_EQ(result.of_cells.count, 2u);
  EXPECT_NEAR(result.of_cells.mean, 0.3, 1e-12);
  EXPECT_NEAR(result.of_cells.standard_deviation, 0.1, 1e-12);
  EXPECT_EQ(result.of_pairs.count, 3u);
  EXPECT_NEAR(result.of_pairs.mean, (0.1 + 0.3 + 0.4) / 3.0, 1e-12);
  EXPECT_NEAR(result.of_pairs.standard_deviation, std::sqrt(0.14 / 9.0), 1e-12);
  EXPECT_NEAR(result.thickness.rms(), 0.1, 1e-12);
  EXPECT_NEAR(result.share, 0.5, 1e-12);
}

TEST(Evaluation, WorstCellsAreListedPointByPoint) {
  MapConsistency result;
  result.worst.push_back({{}, {}, {{{1, 2, 3}}, {{4, 5, 6}, {7, 8, 9.5f}}}});
  EXPECT_EQ(worstCellsCsv(result),
            "cell,segment,x,y,z\n0,0,1.0000,2.0000,3.0000\n0,1,4.0000,5.0000,6.0000\n"
            "0,1,7.0000,8.0000,9.5000\n");
}

}  // namespace
}  // namespace revisit_slam
