// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/drop_remedies.h"

#include <gtest/gtest.h>

#include "revisit_slam/input/scan_reading.h"
#include "revisit_slam/odometry/odometry.h"

namespace revisit_slam {
namespace {

TEST(DropRemedies, EveryReasonOfAMessageHasOne) {
  for (const ScanRejection rejection :
       {ScanRejection::empty, ScanRejection::no_finite_points, ScanRejection::missing_xyz,
        ScanRejection::bad_layout, ScanRejection::bad_stamp, ScanRejection::no_stamp,
        ScanRejection::no_time_field, ScanRejection::unsupported_type})
    EXPECT_NE(remedyForDrop(describe(rejection)), "") << describe(rejection);
  for (const OdometryOutcome outcome :
       {OdometryOutcome::duplicate_stamp, OdometryOutcome::time_went_back,
        OdometryOutcome::no_point_in_range})
    EXPECT_NE(remedyForDrop(toString(outcome)), "") << toString(outcome);
  for (const char* reason : {"queue full", "no transform from 'lidar'", "unreadable",
                             "stamp ahead of the next one", "too small a part of a sweep"})
    EXPECT_NE(remedyForDrop(reason), "") << reason;
}

TEST(DropRemedies, TheCommonestReasonIsSaidWithItsRemedy) {
  ScanAccount account;
  EXPECT_EQ(describeDrops(account), "");
  account.received = 30;
  account.dropped = {{"no points", 1}, {"no stamp", 28}};
  EXPECT_EQ(
      describeDrops(account),
      "29 of 30 scans dropped, 28 of them for 'no stamp': the header stamps are zero: let the "
      "driver set them, or set input/stamps to arrival");
}

}  // namespace
}  // namespace revisit_slam
