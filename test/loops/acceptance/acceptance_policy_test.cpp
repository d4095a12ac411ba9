// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/acceptance_policy.h"

#include <gtest/gtest.h>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

using Names = std::vector<std::string>;

Names namesOf(const AcceptancePolicy& policy) {
  Names names;
  for (const Gate& gate : policy) names.push_back(gate.name);
  return names;
}

RegisteredPair goodPair() {
  RegisteredPair pair;
  pair.registration.outcome = FineRegistrationOutcome::converged;
  pair.registration.inliers = 1000;
  pair.registration.fitness = pair.registration.coherence = 0.9;
  return pair;
}

Names outcomes(LoopOrigin origin, const std::vector<RegisteredPair>& pairs,
               const LoopCloserConfig& config = {}) {
  Names names;
  for (const LoopVerdict& verdict : judge(pairs, acceptancePolicy(origin, config)))
    names.push_back(verdict.outcome());
  return names;
}

TEST(AcceptancePolicy, ListsTheGatesOfEachOriginInOrder) {
  const Names appearance{"correspondences", "convergence", "fitness", "coherence",
                         "translation",     "rotation",    "drift",   "ambiguity",
                         "lone rotation",   "consistency"};
  const Names retroactive{"correspondences", "convergence",      "fitness",       "coherence",
                          "translation",     "rotation",         "drift",         "ambiguity",
                          "lone coherence",  "lone translation", "lone rotation", "consistency"};
  EXPECT_EQ(namesOf(acceptancePolicy(LoopOrigin::appearance, {})), appearance);
  EXPECT_EQ(namesOf(acceptancePolicy(LoopOrigin::retroactive, {})), retroactive);
  EXPECT_EQ(gateNames(), retroactive);
}

TEST(AcceptancePolicy, ThePaperAsksForFitnessAlone) {
  LoopCloserConfig config;
  config.acceptance = "fitness";
  for (const LoopOrigin origin : {LoopOrigin::appearance, LoopOrigin::retroactive}) {
    EXPECT_EQ(namesOf(acceptancePolicy(origin, config)), (Names{"correspondences", "fitness"}));
    RegisteredPair pair = goodPair();
    pair.registration.T_target_source.translation.x() = 60.0;
    pair.registration.coherence = 0.0;
    EXPECT_EQ(outcomes(origin, {pair}, config), Names{"accepted"});
    pair.registration.fitness = 0.25;
    EXPECT_EQ(outcomes(origin, {pair}, config), Names{"fitness"});
  }
}

TEST(AcceptancePolicy, WhatTheFirstGateOfTheListRejectsIsSaid) {
  for (const LoopOrigin origin : {LoopOrigin::appearance, LoopOrigin::retroactive}) {
    RegisteredPair pair = goodPair();
    EXPECT_EQ(outcomes(origin, {pair}), Names{"accepted"});
    pair.registration.T_target_source.translation.x() = 6.1;
    EXPECT_EQ(outcomes(origin, {pair}), Names{"translation"});
    pair.registration.coherence = 0.49;
    EXPECT_EQ(outcomes(origin, {pair}), Names{"coherence"});
    pair.registration.fitness = 0.25;
    EXPECT_EQ(outcomes(origin, {pair}), Names{"fitness"});
    pair.registration.outcome = FineRegistrationOutcome::max_iterations;
    EXPECT_EQ(outcomes(origin, {pair}), Names{"convergence"});
    pair.registration.inliers = 199;
    EXPECT_EQ(outcomes(origin, {pair}), Names{"correspondences"});
  }
}

TEST(AcceptancePolicy, ALonePairHasStricterLimits) {
  RegisteredPair turned = goodPair(), moved = goodPair(), incoherent = goodPair();
  turned.registration.T_target_source.rotation = expSO3({0, 0, 5.1 * M_PI / 180.0});
  moved.registration.T_target_source.translation.x() = 0.31;
  incoherent.registration.coherence = 0.74;
  for (const RegisteredPair& pair : {turned, moved, incoherent})
    EXPECT_EQ(outcomes(LoopOrigin::retroactive, {pair, pair}), Names(2, "accepted"));
  EXPECT_EQ(outcomes(LoopOrigin::appearance, {turned}), Names{"lone rotation"});
  EXPECT_EQ(outcomes(LoopOrigin::appearance, {moved}), Names{"accepted"});
  EXPECT_EQ(outcomes(LoopOrigin::appearance, {incoherent}), Names{"accepted"});
  EXPECT_EQ(outcomes(LoopOrigin::retroactive, {turned}), Names{"lone rotation"});
  EXPECT_EQ(outcomes(LoopOrigin::retroactive, {moved}), Names{"lone translation"});
  EXPECT_EQ(outcomes(LoopOrigin::retroactive, {incoherent}), Names{"lone coherence"});
  LoopCloserConfig config;
  config.min_coherence = 0.0;  // switches off both
  EXPECT_EQ(outcomes(LoopOrigin::retroactive, {incoherent}, config), Names{"accepted"});
}

TEST(AcceptancePolicy, IncoherentPairsOpposeWhatWasNotRecognised) {
  RegisteredPair incoherent = goodPair();
  incoherent.registration.coherence = 0.4;
  const std::vector<RegisteredPair> pairs{goodPair(), incoherent};
  EXPECT_EQ(outcomes(LoopOrigin::appearance, pairs), (Names{"accepted", "coherence"}));
  EXPECT_EQ(outcomes(LoopOrigin::retroactive, pairs), (Names{"consistency", "coherence"}));
}

}  // namespace
}  // namespace revisit_slam
