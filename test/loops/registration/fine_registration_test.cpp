// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/registration/fine_registration.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "support/synthetic_street.h"

namespace revisit_slam {
namespace {

const FineRegistrationConfig kConfig;

struct Visits {
  Submap source, target;
  RegistrationCloud source_cloud{source, kConfig}, target_cloud{target, kConfig};
  Pose T_target_source = target.T_odom_submap.inverse() * source.T_odom_submap;

  FineRegistrationResult align(const Pose& guess) const {
    return FineRegistration(kConfig).align(source_cloud, target_cloud, guess);
  }
};

/// Two drives through one street, the second displaced sideways, or from the other end.
Visits visitTwice(double from, double to) {
  SyntheticStreet first(5, 1), second(5, 2);
  return {submapOf(second, drive(from, to, 1.5)), submapOf(first, drive(0, 25))};
}

Tangent guessError(double metres, double degrees, RandomNumbers& random) {
  Tangent e = Tangent::Zero();
  const double azimuth = random.uniform(0, 2 * M_PI);
  e.head<2>() = metres * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
  e.tail<3>() = degrees * M_PI / 180.0 *
                Eigen::Vector3d(0.1, -0.1, random.uniform(-1, 1) > 0 ? 1 : -1).normalized();
  return e;
}

void expectRecovered(const Visits& visits, double metres, double degrees, unsigned seed) {
  RandomNumbers random(seed);
  for (int round = 0; round < 4; ++round) {
    const Tangent error = guessError(metres, degrees, random);
    const FineRegistrationResult result = visits.align(boxplus(visits.T_target_source, error));
    EXPECT_EQ(result.outcome, FineRegistrationOutcome::converged);
    const Tangent remaining = log(visits.T_target_source.inverse() * result.T_target_source);
    EXPECT_LT(remaining.head<3>().norm(), 0.02) << error.transpose();
    EXPECT_LT(remaining.tail<3>().norm(), 0.1 * M_PI / 180.0) << error.transpose();
    EXPECT_GT(result.fitness, 0.5);
    EXPECT_GT(result.coherence, 0.8);
  }
}

TEST(FineRegistration, RecoversASmallOffset) {
  expectRecovered(visitTwice(3, 28), 1.0, 2.0, 21);
}
TEST(FineRegistration, RecoversALargeOffset) {
  expectRecovered(visitTwice(3, 28), 2.0, 5.0, 22);
}
TEST(FineRegistration, RecoversTheOppositeDirection) {
  expectRecovered(visitTwice(35, 10), 1.5, 4.0, 23);
}

TEST(FineRegistration, AnotherStreetIsIncoherentOrUnfit) {
  SyntheticStreet here(5, 1), elsewhere(6, 2);
  const Visits visits{submapOf(elsewhere, drive(0, 25)), submapOf(here, drive(0, 25))};
  RandomNumbers random(24);
  for (int round = 0; round < 6; ++round) {
    const FineRegistrationResult result = visits.align(exp(guessError(1.0, 3.0, random)));
    EXPECT_TRUE(result.fitness < 0.25 || result.coherence < 0.5)
        << result.fitness << " " << result.coherence;
  }
}

TEST(FineRegistration, NothingInCommonIsSaid) {
  const Visits visits = visitTwice(3, 28);
  const FineRegistrationResult result = visits.align({{1, 0, 0, 0}, {0, 0, 500}});
  EXPECT_EQ(result.outcome, FineRegistrationOutcome::too_few_correspondences);
  EXPECT_EQ(result.fitness, 0.0);
}

TEST(FineRegistration, DoesNotDependOnThreads) {
  const Visits visits = visitTwice(3, 28);
  const Pose guess = boxplus(visits.T_target_source, (Tangent() << 1, 1, 0, 0, 0, 0.05).finished());
  FineRegistrationResult one, four;
  tbb::task_arena(1).execute([&] { one = visits.align(guess); });
  tbb::task_arena(4).execute([&] { four = visits.align(guess); });
  EXPECT_EQ(one.T_target_source.matrix(), four.T_target_source.matrix());
  EXPECT_EQ(one.fitness, four.fitness);
  EXPECT_EQ(one.coherence, four.coherence);
  EXPECT_EQ(one.iterations, four.iterations);
}

}  // namespace
}  // namespace revisit_slam
