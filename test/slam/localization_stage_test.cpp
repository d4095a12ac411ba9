// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/localization_stage.h"

#include <gtest/gtest.h>

#include "revisit_slam/slam/slam.h"
#include "support/simulated_slam.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

/// A drive around some blocks is mapped, and another one the other way round finds itself in the
/// map, among other cars.
TEST(LocalizationStage, FindsAnotherDriveInTheMapOfASession) {
  const TemporaryFolder folder;
  SlamConfig config;
  config.occupancy.enabled = false;
  const auto simulated = [&](const simulation::VisitConfig& visit) {
    return simulateInformedDrive("loop", 300.0, "spinning-16", 512, 3, config, visit);
  };
  const InformedDrive first = simulated({});
  {
    SlamRecorder recorder;
    InlineExecutor executor;
    Slam slam(config, recorder, executor, [&](SessionId, Stamp) {
      return SessionTarget{folder.file("session"), "", nullptr, false};
    });
    for (const InformedScan& scan : first.scans) slam.insert(scan);
    slam.finish();
    slam.session()->writeRest();
  }
  config.localization.map = folder.file("session");
  std::vector<std::string> notices;
  LocalizationStage stage(config, notices);
  EXPECT_TRUE(notices.empty()) << notices.front();
  const InformedDrive second = simulated({1, true, 0.0});
  // The map begins with the first drive's first pose.
  const Pose T_map_world = first.truth.front().inverse();
  std::size_t localized = 0;
  for (std::size_t i = 0; i < second.scans.size(); ++i) {
    const Localization now = stage.add(second.scans[i]);
    if (now.state != LocalizationState::localized) continue;
    ++localized;
    const Eigen::Vector3d truth = (T_map_world * second.truth[i]).translation;
    EXPECT_LT((now.T_map_base.translation - truth).norm(), 1.0) << i;
  }
  EXPECT_GT(localized, second.scans.size() / 2);
}

TEST(LocalizationStage, WithoutAMapThereIsNone) {
  SlamConfig config;
  config.localization.map = "/nowhere";
  std::vector<std::string> notices;
  EXPECT_THROW(LocalizationStage(config, notices), std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
