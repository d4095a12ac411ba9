// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/pose_window.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

class PoseWindowTest : public testing::Test {
 protected:
  /// The odometry goes 1 m along x.
  void go() {
    const double x = static_cast<double>(scans_);
    window_.add({ScanId{scans_++},
                 {},
                 {Eigen::Quaterniond::Identity(), {x, 0.0, 0.0}},
                 1e4 * Matrix6::Identity()});
  }
  void fix(double y, double weight) {
    const double x = static_cast<double>(scans_ - 1);
    window_.fix({Eigen::Quaterniond::Identity(), {x, y, 0.0}}, weight * Matrix6::Identity());
  }
  double y() const { return window_.solve()->translation.y(); }

  std::uint32_t scans_ = 0;
  PoseWindow window_{BackEndConfig{}};
};

TEST_F(PoseWindowTest, WithoutAFixNothingIsKnown) {
  go();
  EXPECT_FALSE(window_.solve());
  fix(3.0, 100.0);
  EXPECT_NEAR(y(), 3.0, 1e-6);
  go();  // carried along
  EXPECT_NEAR(y(), 3.0, 1e-6);
  window_.clearFixes();
  EXPECT_FALSE(window_.solve());
}

TEST_F(PoseWindowTest, FixesAreWeighedAndShareOneDrift) {
  for (const double y : {0.1, -0.1, 0.1, -0.1}) {
    go();
    fix(y, 100.0);
  }
  EXPECT_LT(std::abs(y()), 0.05);
  go();
  fix(1.0, 1e-3);
  EXPECT_LT(std::abs(y()), 0.05);
}

TEST_F(PoseWindowTest, OneAmongManyThatIsFarOffHardlyCounts) {
  for (int i = 0; i < 8; ++i) {
    go();
    fix(i == 6 ? 5.0 : 0.0, 1e3);
  }
  EXPECT_LT(std::abs(y()), 0.1);
}

TEST_F(PoseWindowTest, WhatIsFarBehindIsForgotten) {
  go();
  fix(2.0, 100.0);
  for (int i = 0; i < 20; ++i) go();
  window_.shorten(30.0);
  EXPECT_TRUE(window_.solve());
  window_.shorten(10.0);
  EXPECT_FALSE(window_.solve());
}

}  // namespace
}  // namespace revisit_slam
