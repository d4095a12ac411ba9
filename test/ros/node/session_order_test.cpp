// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/session_order.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

TEST(SessionOrder, sessionsBeginWithScanZeroAndGoOnWithoutGaps) {
  SessionOrder order;
  EXPECT_EQ(order.take(7, ScanId{0}), ScanOrder::first);
  EXPECT_EQ(order.take(7, ScanId{1}), ScanOrder::next);
  EXPECT_EQ(order.scans(), 2u);
  EXPECT_EQ(order.take(9, ScanId{0}), ScanOrder::first);
  EXPECT_EQ(order.session(), 9);
  EXPECT_EQ(order.scans(), 1u);
}

TEST(SessionOrder, whoeverMissedScansWaitsForTheNextSession) {
  SessionOrder order;
  EXPECT_EQ(order.take(7, ScanId{4}), ScanOrder::missed);
  EXPECT_FALSE(order.session());
  EXPECT_EQ(order.take(8, ScanId{0}), ScanOrder::first);
  EXPECT_EQ(order.take(8, ScanId{2}), ScanOrder::missed);
  EXPECT_EQ(order.take(9, ScanId{1}), ScanOrder::missed);
  EXPECT_EQ(order.take(8, ScanId{1}), ScanOrder::next);
}

}  // namespace
}  // namespace revisit_slam
