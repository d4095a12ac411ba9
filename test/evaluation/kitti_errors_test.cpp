// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>

#include "evaluation/evaluation_fixtures.h"
#include "revisit_slam/evaluation/absolute_error.h"
#include "revisit_slam/evaluation/relative_error.h"

namespace revisit_slam {
namespace {

/// What evo 1.38.1 and the definition of the KITTI development kit say: the output of
/// scripts/check_evaluation.
struct KnownErrors {
  const char* route;
  double rmse, median, max, translation_percent, rotation_deg_per_m;
};

/// The drift of scripts/check_evaluation.
Trajectory drifted(const Trajectory& reference) {
  Trajectory result{reference.front()};
  for (std::size_t k = 1; k < reference.size(); ++k) {
    const auto i = static_cast<double>(k);
    const Eigen::Vector3d turn(std::sin(0.011 * i), std::sin(0.007 * i), 0.5);
    const Eigen::Vector3d shift(std::sin(0.013 * i), 0.4, std::cos(0.017 * i));
    const Pose error{expSO3(1e-4 * turn), 3e-3 * shift};
    const Pose motion = reference[k - 1].T_world_base.inverse() * reference[k].T_world_base;
    result.push_back({reference[k].stamp, result.back().T_world_base * motion * error});
  }
  return result;
}

class KittiErrors : public testing::TestWithParam<KnownErrors> {};

TEST_P(KittiErrors, AreThoseOfEvoAndOfTheDevelopmentKit) {
  const char* folder = std::getenv("REVISIT_SLAM_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "REVISIT_SLAM_TEST_DATA is not set";
  const KnownErrors& known = GetParam();
  Trajectory reference;
  for (const Pose& T : readKitti(std::string(folder) + "/trajectories/" + known.route + ".txt"))
    reference.push_back({stampOf(reference.size()), T});
  const TrajectoryMatch match = matchOf(drifted(reference), reference);
  const AbsoluteError absolute = absoluteError(match);
  const RelativeError relative = relativeError(match);
  const auto expect_equal = [](double value, double expected) {
    EXPECT_NEAR(value, expected, 1e-9 * expected);
  };
  expect_equal(absolute.rmse, known.rmse);
  expect_equal(absolute.median, known.median);
  expect_equal(absolute.max, known.max);
  expect_equal(relative.translation_percent, known.translation_percent);
  expect_equal(relative.rotation_deg_per_m, known.rotation_deg_per_m);
}

INSTANTIATE_TEST_SUITE_P(
    All, KittiErrors,
    testing::Values(KnownErrors{"kitti_00", 4.66525025431381, 3.93357369365401, 10.7557976194863,
                                0.906301551978246, 0.0040363062508511},
                    KnownErrors{"kitti_05", 2.56231811091678, 2.27259501742313, 5.71238256238117,
                                0.87744761270694, 0.00471660828352851},
                    KnownErrors{"kitti_07", 1.60937115698477, 1.47472257733383, 2.65520754673216,
                                0.796000678681083, 0.00561072726157755}),
    [](const auto& info) { return info.param.route; });

}  // namespace
}  // namespace revisit_slam
