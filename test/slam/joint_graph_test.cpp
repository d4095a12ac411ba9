// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/joint_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

constexpr int kSubmaps = 12, kSubmapsOfAMap = 4;
constexpr double kStep = 25.0;  // m

/// Where a drive is at its keyposes: along a street from `begin` on, every second one back.
std::vector<Pose> truth(double begin, bool back) {
  std::vector<Pose> T;
  for (int k = 0; k < kSubmaps; ++k) {
    const double at = begin + kStep * (back ? kSubmaps - 1 - k : k);
    T.push_back({expSO3({0.0, 0.0, back ? M_PI : 0.0}), {at, back ? 3.0 : 0.0, 0.0}});
  }
  return T;
}

/// A drive whose odometry turns a little too much, with keyposes alone.
SessionSummary drive(const std::string& name, const std::vector<Pose>& truth, unsigned seed) {
  RandomNumbers random(seed);
  SessionSummary session;
  session.name = name;
  Pose T_odom;
  for (int k = 0; k < kSubmaps; ++k) {
    if (k > 0)
      T_odom = T_odom * (truth[k - 1].inverse() * truth[k]) *
               Pose{expSO3({0.0, 0.0, 0.002 * random.uniform(0.5, 1.0)}), {0.05, 0.0, 0.0}};
    SummarisedSubmap submap;
    submap.id.value = static_cast<std::uint32_t>(k);
    submap.local_map.value = static_cast<std::uint32_t>(k / kSubmapsOfAMap);
    submap.travelled_begin = kStep * k;
    submap.T_odom_submap = submap.T_map_submap = T_odom;
    submap.information.diagonal() << 100, 100, 100, 1e5, 1e5, 1e5;
    session.submaps.push_back(submap);
  }
  return session;
}

/// Loops from all keyposes of the source to those of the target that are within 10 m.
SessionCrossing crossing(const std::string& source, const std::vector<Pose>& T_source,
                         const std::string& target, const std::vector<Pose>& T_target,
                         const Pose& error = {}) {
  SessionCrossing crossing{source, target, {}, {}};
  for (std::uint32_t k = 0; k < kSubmaps; ++k)
    for (std::uint32_t r = 0; r < kSubmaps; ++r) {
      if ((T_source[k].translation - T_target[r].translation).norm() > 10.0) continue;
      LoopConstraint loop;
      loop.source.value = k;
      loop.target.value = r;
      loop.source_map.value = k / kSubmapsOfAMap;
      loop.target_map.value = r / kSubmapsOfAMap;
      loop.constraint.T_from_to = T_target[r].inverse() * error * T_source[k];
      loop.constraint.information = 1e4 * Matrix6::Identity();
      crossing.loops.push_back(loop);
    }
  return crossing;
}

/// Three drives that overlap by some 200 m each, c only with b, and one elsewhere.
class JointGraphTest : public testing::Test {
 protected:
  JointGraphTest() {
    for (const auto& [name, T] : {std::pair("a", a_), {"b", b_}, {"c", c_}, {"far", far_}})
      sessions_.push_back(drive(name, T, static_cast<unsigned>(sessions_.size())));
    crossings_ = {crossing("b", b_, "a", a_), crossing("c", c_, "b", b_)};
  }

  JointGraph joint() const { return JointGraph(config_, sessions_, crossings_); }

  /// Of the keyposes of a session in the map of a, whose first keypose is where the truth has it.
  static double error(const JointGraph& joint, std::size_t session, const std::vector<Pose>& T) {
    double largest = 0.0;
    const std::vector<Pose> keyposes = joint.keyposes(session);
    for (std::size_t k = 0; k < T.size(); ++k)
      largest = std::max(largest, (keyposes[k].translation - T[k].translation).norm());
    return largest;
  }

  const SlamConfig config_;
  const std::vector<Pose> a_ = truth(0.0, false), b_ = truth(100.0, true), c_ = truth(200.0, false),
                          far_ = truth(5000.0, false);
  std::vector<SessionSummary> sessions_;
  std::vector<SessionCrossing> crossings_;
};

TEST_F(JointGraphTest, SessionsThatAgreeLieInOneMap) {
  const JointGraph joint = this->joint();
  for (std::size_t session = 0; session < 3; ++session) EXPECT_EQ(joint.groupOf(session), 0u);
  EXPECT_EQ(joint.groupOf(3), 3u);
  // The way from a to the end of c is 475 m, with loops along 350 m of it.
  EXPECT_LT(error(joint, 0, a_), 3.0);
  const Pose across = joint.keyposes(1)[11].inverse() * joint.keyposes(0)[4];
  EXPECT_LT(distanceBetween(across, b_[11].inverse() * a_[4]), 0.05);
  for (const LoopEdge& edge : joint.loopsBetweenSessions()) {
    EXPECT_EQ(edge.state, LoopState::active);
    EXPECT_LT(joint.residual(edge).translation.norm(), 0.1);
  }
  EXPECT_EQ(joint.leftOut(), 0u);
}

/// What two sessions show of each other by chance is believed neither by itself nor against more.
TEST_F(JointGraphTest, WrongLoopsAreLeftOut) {
  const Pose wrong{expSO3({0.0, 0.0, 0.5}), {40.0, 20.0, 0.0}};
  crossings_.push_back(crossing("c", c_, "a", a_, wrong));  // more than 3 sigma from a over b
  SessionCrossing lone = crossing("far", a_, "a", a_);
  lone.loops.resize(1);
  crossings_.push_back(lone);
  const JointGraph joint = this->joint();
  EXPECT_EQ(joint.groupOf(2), 0u);
  EXPECT_EQ(joint.groupOf(3), 3u);
  EXPECT_GE(joint.leftOut(), 1u);
  const Pose across = joint.keyposes(2)[0].inverse() * joint.keyposes(1)[7];
  EXPECT_LT(distanceBetween(across, c_[0].inverse() * b_[7]), 0.05);
}

TEST_F(JointGraphTest, TheOrderOfTheCrossingsDoesNotMatter) {
  crossings_.push_back(crossing("c", c_, "a", a_));
  const JointGraph once = joint();
  std::reverse(crossings_.begin(), crossings_.end());
  for (SessionCrossing& crossing : crossings_)
    std::reverse(crossing.loops.begin(), crossing.loops.end());
  const JointGraph again = joint();
  for (std::size_t session = 0; session < sessions_.size(); ++session)
    for (int k = 0; k < kSubmaps; ++k) {
      EXPECT_EQ(once.keyposes(session)[k].translation, again.keyposes(session)[k].translation);
      EXPECT_EQ(once.keyposes(session)[k].rotation.coeffs(),
                again.keyposes(session)[k].rotation.coeffs());
    }
}

TEST_F(JointGraphTest, CrossingsOfSessionsThatAreNotThereAreLeftOut) {
  sessions_.pop_back();
  crossings_.push_back(crossing("far", far_, "a", a_));
  EXPECT_NO_THROW(joint());
  sessions_.push_back(sessions_.front());
  EXPECT_THROW(joint(), std::runtime_error);  // two of one name
}

}  // namespace
}  // namespace revisit_slam
