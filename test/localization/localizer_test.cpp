// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/localizer.h"

#include <gtest/gtest.h>

#include "street_map.h"

namespace revisit_slam {
namespace {

class LocalizerTest : public testing::Test {
 protected:
  LocalizerTest() {
    config_.localization.interval = 5.0;
    config_.localization.open_length = 15.0;
  }

  static constexpr std::size_t kStands = 5;  // scans before the drive begins

  /// Along the street.
  static std::vector<Pose> way(double begin, double end) {
    std::vector<Pose> way = drive(begin, end, 1.0);
    way.insert(way.begin(), kStands, way.front());
    return way;
  }
  static std::vector<Pose> way(double end) { return way(10, end); }
  static Pose start(double off) { return T_map_street() * poseAt(10 + off, 1.0, 0.1 * off); }
  static double errorAt(const Localization& now, const Pose& T_street_base) {
    return (now.T_map_base.translation - (T_map_street() * T_street_base).translation).norm();
  }

  static InformedScan inSession(std::uint32_t session, InformedScan informed) {
    auto scan = std::make_shared<RegisteredScan>(*informed.scan);
    scan->id.session.value = session;
    informed.scan = scan;
    return informed;
  }
  static InformedScan withoutPoints(InformedScan informed) {
    auto scan = std::make_shared<RegisteredScan>(*informed.scan);
    scan->points_base.clear();
    informed.scan = scan;
    return informed;
  }

  LocalizerConfig config_;
};

TEST_F(LocalizerTest, FromAPoseThatWasDrawnItKnowsAtOnceAndFollows) {
  Localizer localizer(config_, streetMap());
  localizer.startAt(start(2.0));  // and 11 degrees
  const std::vector<Pose> way = this->way(50);
  const std::vector<InformedScan> scans = scansAlong(way);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Localization now = localizer.add(scans[i]);
    if (i < kStands) continue;
    EXPECT_TRUE(now.attempted);
    EXPECT_EQ(now.state, LocalizationState::localized) << i << " " << now.reason;
    EXPECT_LT(errorAt(now, way[i]), 0.1) << i;
    const double deviation = config_.localization.deviation;
    EXPECT_GT(now.covariance(0, 0), deviation * deviation);
    EXPECT_LT(now.covariance(0, 0), 0.05 * 0.05);
  }
}

/// As where the map is loaded while the base drives.
TEST_F(LocalizerTest, AStartBeforeTheFirstScanHoldsWhereverTheOdometryIs) {
  Localizer localizer(config_, streetMap());
  localizer.startAt(start(0.0));
  const Pose T_new_odom{expSO3({0.0, 0.0, 0.7}), {300.0, -40.0, 0.0}};
  const std::vector<Pose> way = this->way(20);
  std::vector<InformedScan> scans = scansAlong(way);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    auto scan = std::make_shared<RegisteredScan>(*scans[i].scan);
    scan->T_odom_base = T_new_odom * scan->T_odom_base;
    scans[i].scan = std::move(scan);
    const Localization now = localizer.add(scans[i]);
    EXPECT_LT(errorAt(now, way[i]), 0.1) << i;
    EXPECT_EQ(now.state, i < kStands ? LocalizationState::candidate : LocalizationState::localized);
  }
}

TEST_F(LocalizerTest, TheStartMayBeAParameter) {
  config_.localization.start = "110.5 1 0";
  Localizer localizer(config_, streetMap());
  Localization now;
  for (const InformedScan& scan : scansAlong(way(15))) now = localizer.add(scan);
  EXPECT_EQ(now.state, LocalizationState::localized) << now.reason;
  config_.localization.start = "somewhere";
  EXPECT_THROW(Localizer(config_, streetMap()), ParameterError);
}

TEST_F(LocalizerTest, WithoutStartAndPlacesItSearches) {
  Localizer localizer(config_, streetMap());
  for (const InformedScan& scan : scansAlong(way(50)))
    EXPECT_EQ(localizer.add(scan).state, LocalizationState::searching);
}

TEST_F(LocalizerTest, AfterAWayThroughTheUnknownItIsLostAndFoundAgain) {
  config_.localization.lost_after = 20.0;
  Localizer localizer(config_, streetMap());
  localizer.startAt(start(0.0));
  const std::vector<Pose> there = way(40), back = drive(45, 65, 1.0);
  std::vector<Pose> way = there;
  for (double x = 1000.0; x < 1040.0; x += 5.0) way.push_back(poseAt(x, 0));  // nothing to be seen
  way.insert(way.end(), back.begin(), back.end());
  std::vector<InformedScan> scans = scansAlong(way);
  std::vector<LocalizationState> states;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Localization now = localizer.add(scans[i]);
    states.push_back(now.state);
    if (now.state == LocalizationState::localized && i + 1 == scans.size()) {
      EXPECT_LT(errorAt(now, way[i]), 0.1);
    }
  }
  EXPECT_EQ(states[there.size() - 1], LocalizationState::localized);
  EXPECT_EQ(states[there.size() + 7], LocalizationState::lost);
  EXPECT_EQ(states.back(), LocalizationState::localized);
}

TEST_F(LocalizerTest, AnotherSessionGoesOnWhereTheOneBeforeEnded) {
  Localizer localizer(config_, streetMap());
  localizer.startAt(start(0.0));
  Localization now;
  for (const InformedScan& scan : scansAlong(way(30))) now = localizer.add(scan);
  const Matrix6 covariance = now.covariance;
  const std::vector<Pose> way = this->way(30, 50);
  const std::vector<InformedScan> scans = scansAlong(way);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    now = localizer.add(inSession(1, scans[i]));
    if (i == 0) {
      EXPECT_EQ(now.state, LocalizationState::lost);
      EXPECT_EQ(now.covariance, covariance);
    }
  }
  EXPECT_EQ(now.state, LocalizationState::localized) << now.reason;
  EXPECT_LT(errorAt(now, way.back()), 0.1);
}

/// Nothing is in view until another session begins, 20 m on.
TEST_F(LocalizerTest, APoseThatWasDrawnIsCarriedIntoAnotherSession) {
  Localizer localizer(config_, streetMap());
  localizer.startAt(start(0.0));
  Localization now;
  for (const InformedScan& scan : scansAlong(way(30))) now = localizer.add(withoutPoints(scan));
  EXPECT_EQ(now.state, LocalizationState::candidate);
  EXPECT_GT(now.covariance(0, 0), 1.0);
  const std::vector<Pose> way = this->way(30, 50);
  const std::vector<InformedScan> scans = scansAlong(way);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    now = localizer.add(inSession(1, scans[i]));
    EXPECT_EQ(now.state, i < kStands ? LocalizationState::candidate : LocalizationState::localized)
        << i << " " << now.reason;
    EXPECT_LT(errorAt(now, way[i]), 0.1) << i;
  }
}

TEST_F(LocalizerTest, APoseIsConfirmedWhileTheBaseStands) {
  Localizer localizer(config_, streetMap());
  const std::vector<Pose> way = this->way(20);
  const std::vector<InformedScan> scans = scansAlong(way);
  for (const InformedScan& scan : scans) localizer.add(scan);
  EXPECT_EQ(localizer.add(scans.back()).state, LocalizationState::searching);
  localizer.startAt(T_map_street() * way.back());
  const Localization now = localizer.add(scans.back());
  EXPECT_EQ(now.state, LocalizationState::localized) << now.reason;
  EXPECT_LT(errorAt(now, way.back()), 0.1);
  const Pose T_map_base = now.T_map_odom * scans.back().scan->T_odom_base;
  EXPECT_EQ(now.T_map_base.translation, T_map_base.translation);
  EXPECT_FALSE(localizer.add(scans.back()).attempted);
}

/// The last metres before are no evidence of where the base is now.
TEST_F(LocalizerTest, WhereTheOdometryIsLostThePoseIsNotConfirmedByWhatWasSeenBefore) {
  Localizer localizer(config_, streetMap());
  localizer.startAt(start(0.0));
  const std::vector<Pose> way = this->way(50);
  std::vector<InformedScan> scans = scansAlong(way);
  const std::size_t lost_at = kStands + 4;
  scans[lost_at].verdict = PoseVerdict::lost;
  double since_fix = 0.0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Localization now = localizer.add(i < lost_at ? scans[i] : withoutPoints(scans[i]));
    if (i < kStands) continue;
    EXPECT_EQ(now.state, i < lost_at ? LocalizationState::localized : LocalizationState::lost) << i;
    if (i > lost_at) {
      EXPECT_GE(now.since_fix, since_fix);
    }
    since_fix = now.since_fix;
  }
}

TEST_F(LocalizerTest, AfterALossItIsFoundWhereItIs) {
  Localizer localizer(config_, streetMap());
  localizer.startAt(T_map_street() * poseAt(0.0, 1.0));
  std::vector<Pose> way(kStands, poseAt(0.0, 1.0));
  for (double x = 0.0; x < 60.0; x += 1.5) way.push_back(poseAt(x, 1.0));
  std::vector<InformedScan> scans = scansAlong(way);
  scans[kStands + 12].verdict = PoseVerdict::lost;
  Localization now;
  for (std::size_t i = 0; i < scans.size(); ++i) now = localizer.add(scans[i]);
  EXPECT_EQ(now.state, LocalizationState::localized) << now.reason;
  EXPECT_LT(errorAt(now, way.back()), 0.1);
}

TEST_F(LocalizerTest, APoseThatNothingConfirmsIsGivenUp) {
  config_.localization.search_length = 10.0;  // 37.5 m: 2.5 times open_length
  Localizer localizer(config_, streetMap());
  localizer.startAt(start(0.0));
  std::vector<LocalizationState> states;
  for (const InformedScan& scan : scansAlong(way(60)))
    states.push_back(localizer.add(withoutPoints(scan)).state);
  EXPECT_EQ(states[kStands + 7], LocalizationState::candidate);  // after 35 m
  EXPECT_EQ(states.back(), LocalizationState::searching);
}

/// However rare attempts are, the one after next can confirm what the first has found.
TEST_F(LocalizerTest, RareAttemptsConfirmEachOther) {
  config_.localization.interval = config_.localization.search_length = 10.0;
  config_.localization.open_length = 10.0;
  config_.localization.lost_after = 15.0;
  Localizer localizer(config_, streetMap());
  localizer.startAt(T_map_street() * poseAt(0.0, 1.0));
  std::vector<Pose> way(kStands, poseAt(0.0, 1.0));
  for (double x = 0.0; x < 60.0; x += 1.5) way.push_back(poseAt(x, 1.0));  // attempts: 10.5 m
  const std::vector<InformedScan> scans = scansAlong(way);
  std::vector<LocalizationState> states;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const bool sees = i < 8 || i > 27;
    states.push_back(localizer.add(sees ? scans[i] : withoutPoints(scans[i])).state);
  }
  EXPECT_EQ(states[8], LocalizationState::localized);
  EXPECT_EQ(states[27], LocalizationState::lost);
  EXPECT_EQ(states.back(), LocalizationState::localized);
}

}  // namespace
}  // namespace revisit_slam
