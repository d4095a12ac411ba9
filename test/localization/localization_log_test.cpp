// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/localization_log.h"

#include <gtest/gtest.h>

#include "revisit_slam/io/trajectory.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

Localization at(std::uint32_t scan, LocalizationState state) {
  Localization now;
  now.scan = ScanId{scan};
  now.stamp = Stamp{1'700'000'000'000'000'000 + 100'000'000LL * scan};
  now.state = state;
  now.T_map_base.translation = {1.0 * scan, 2.0, 3.0};
  return now;
}

TEST(LocalizationLog, PosesBeginWithTheFirstFixAndStatesWithTheFirstScan) {
  const TemporaryFolder folder;
  LocalizationLog log(folder.file(""));
  log.add(at(0, LocalizationState::searching));
  log.add(at(1, LocalizationState::candidate));
  Localization fixed = at(2, LocalizationState::localized);
  fixed.attempted = true;
  fixed.target = SubmapId{7, SessionId{1}};
  fixed.overlap = 0.75;
  fixed.coherence = 0.5;
  fixed.covariance.diagonal().head<3>() = Eigen::Vector3d(0.25, 0.04, 0.01);
  log.add(fixed);
  Localization lost = at(3, LocalizationState::lost);
  lost.since_fix = 12.5;
  lost.reason = "off the map";
  log.add(lost);
  const Trajectory written = readTum(folder.file("localized.tum"));
  ASSERT_EQ(written.size(), 2u);
  EXPECT_EQ(written[0].stamp, fixed.stamp);
  EXPECT_EQ(written[1].T_world_base.translation, lost.T_map_base.translation);
  EXPECT_EQ(textOf(folder.file("localization.csv")),
            "stamp,scan,state,since_fix_m,attempted,target,target_session,overlap,coherence,"
            "sigma_x,sigma_y,sigma_z,reason\n"
            "1700000000.000000000,0,searching,0,0,,,0,0,0,0,0,\n"
            "1700000000.100000000,1,candidate,0,0,,,0,0,0,0,0,\n"
            "1700000000.200000000,2,localized,0,1,7,1,0.75,0.5,0.5,0.2,0.1,\n"
            "1700000000.300000000,3,lost,12.5,0,,,0,0,0,0,0,off the map\n");
}

}  // namespace
}  // namespace revisit_slam
