// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/session_order.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

TEST(SessionOrder, sessionsBeginWithScanZeroAndGoOnWithoutGaps) {
  SessionOrder order;
  EXPECT_EQ(order.take(ScanId{0, {7}}), ScanOrder::first);
  EXPECT_EQ(order.take(ScanId{1, {7}}), ScanOrder::next);
  EXPECT_EQ(order.scans(), 2u);
  EXPECT_EQ(order.take(ScanId{0, {9}}), ScanOrder::first);
  EXPECT_EQ(order.session(), SessionId{9});
  EXPECT_EQ(order.scans(), 1u);
}

TEST(SessionOrder, scansOfABaseThatRestsRepeatTheOneBefore) {
  SessionOrder order;
  order.take(ScanId{0, {7}});
  EXPECT_EQ(order.take(ScanId{0, {7}}), ScanOrder::repeated);
  EXPECT_EQ(order.take(ScanId{1, {7}}), ScanOrder::next);
  EXPECT_EQ(order.take(ScanId{1, {7}}), ScanOrder::repeated);
  EXPECT_EQ(order.take(ScanId{0, {7}}), ScanOrder::missed);
  EXPECT_EQ(order.take(ScanId{1, {8}}), ScanOrder::missed);
  EXPECT_EQ(order.scans(), 2u);
}

TEST(SessionOrder, whoeverMissedScansWaitsForTheNextSession) {
  SessionOrder order;
  EXPECT_EQ(order.take(ScanId{4, {7}}), ScanOrder::missed);
  EXPECT_FALSE(order.session());
  EXPECT_EQ(order.take(ScanId{0, {8}}), ScanOrder::first);
  EXPECT_EQ(order.take(ScanId{2, {8}}), ScanOrder::missed);
  EXPECT_EQ(order.take(ScanId{1, {9}}), ScanOrder::missed);
  EXPECT_EQ(order.take(ScanId{1, {8}}), ScanOrder::next);
}

}  // namespace
}  // namespace revisit_slam
