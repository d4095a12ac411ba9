// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/verdict_notice.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

InformedScan scanWith(PoseVerdict verdict) {
  auto scan = std::make_shared<RegisteredScan>();
  scan->registration.explained = 0.42;
  scan->jump = 7.0;
  InformedScan informed;
  informed.scan = scan;
  informed.verdict = verdict;
  return informed;
}

TEST(VerdictNotice, saysOnceWhatHasChanged) {
  VerdictNotice notice;
  EXPECT_EQ(notice.take(scanWith(PoseVerdict::good)), "");
  EXPECT_EQ(notice.take(scanWith(PoseVerdict::weak)), "");
  EXPECT_EQ(notice.take(scanWith(PoseVerdict::poor)),
            "the pose is poor: the map explains 42 % of the scan, and the pose is 7.0 standard "
            "deviations from the prediction");
  EXPECT_EQ(notice.take(scanWith(PoseVerdict::poor)), "");
  EXPECT_NE(notice.take(scanWith(PoseVerdict::lost)).find("lost"), std::string::npos);
  EXPECT_EQ(notice.take(scanWith(PoseVerdict::good)), "the scans fit the map again");
  EXPECT_EQ(notice.take(scanWith(PoseVerdict::good)), "");
}

TEST(VerdictNotice, everyLossIsSaid) {
  VerdictNotice notice;
  EXPECT_NE(notice.take(scanWith(PoseVerdict::lost)), "");
  EXPECT_NE(notice.take(scanWith(PoseVerdict::lost)), "");
}

}  // namespace
}  // namespace revisit_slam
