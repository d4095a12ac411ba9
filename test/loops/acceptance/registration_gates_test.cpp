// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/registration_gates.h"

#include <gtest/gtest.h>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

/// What is said of one pair: "accepted", or why not.
std::string verdictOf(const RegisteredPair& pair, const Gate& gate) {
  const LoopVerdict verdict = judge({pair}, {gate}).front();
  return verdict.isAccepted() ? verdict.outcome() : verdict.reason();
}

TEST(RegistrationGates, Correspondences) {
  RegisteredPair pair;
  pair.registration.inliers = 199;
  EXPECT_EQ(verdictOf(pair, correspondencesGate(200)), "correspondences 199 < 200");
  EXPECT_EQ(verdictOf(pair, correspondencesGate(199)), "accepted");
}

TEST(RegistrationGates, Convergence) {
  RegisteredPair pair;
  pair.registration.outcome = FineRegistrationOutcome::max_iterations;
  EXPECT_EQ(verdictOf(pair, convergenceGate()), "convergence 0 < 1");
  pair.registration.outcome = FineRegistrationOutcome::converged;
  EXPECT_EQ(verdictOf(pair, convergenceGate()), "accepted");
}

TEST(RegistrationGates, FitnessIsAboveItsLimit) {
  RegisteredPair pair;
  pair.registration.fitness = 0.25;
  EXPECT_EQ(verdictOf(pair, fitnessGate(0.25)), "fitness 0.25 <= 0.25");
  EXPECT_EQ(verdictOf(pair, fitnessGate(0.24)), "accepted");
}

TEST(RegistrationGates, CoherenceIsNotBelowItsLimit) {
  RegisteredPair pair;
  pair.registration.coherence = 0.5;
  EXPECT_EQ(verdictOf(pair, coherenceGate(0.51)), "coherence 0.5 < 0.51");
  EXPECT_EQ(verdictOf(pair, coherenceGate(0.5)), "accepted");
  pair.registration.coherence = 0.0;
  EXPECT_EQ(verdictOf(pair, coherenceGate(0.0)), "accepted");  // switched off
}

TEST(RegistrationGates, DistanceFromTheGuess) {
  RegisteredPair pair;
  pair.registration.T_target_source = {expSO3({0, 0, 0.1}), {3, 4, 0}};
  EXPECT_EQ(verdictOf(pair, translationGate(4.9)), "translation 5 m > 4.9 m");
  EXPECT_EQ(verdictOf(pair, translationGate(5.1)), "accepted");
  EXPECT_EQ(verdictOf(pair, rotationGate(5.0)), "rotation 5.73 deg > 5 deg");
  EXPECT_EQ(verdictOf(pair, rotationGate(6.0)), "accepted");
}

TEST(RegistrationGates, WhatTheDriftAllows) {
  RegisteredPair pair;
  pair.registration.T_target_source.translation = {5, 0, 0};
  EXPECT_EQ(verdictOf(pair, driftGate({})), "accepted");  // nothing is known
  pair.prior.drift = {1.0, 0.3};
  EXPECT_EQ(verdictOf(pair, driftGate({})), "drift 5 sigma > 3 sigma");
  pair.prior.drift = {2.0, 0.6};
  EXPECT_EQ(verdictOf(pair, driftGate({})), "accepted");
}

TEST(RegistrationGates, WithoutEvidenceNothingSpeaksAgainstALoop) {
  const RegisteredPair pair;
  EXPECT_EQ(verdictOf(pair, ambiguityGate(0.0, 6.0)), "accepted");
}

}  // namespace
}  // namespace revisit_slam
