// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "revisit_slam/loops/acceptance/loop_prior.h"
#include "revisit_slam/loops/registration/fine_registration.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// A registered pair of submaps as gates see it. The common frame is one that all pairs of the same
/// two local maps share: that of the target local map (appearance), which may be tilted, or the map
/// (retroactive).
struct RegisteredPair {
  Pose T_common_target;  ///< before the registration
  Pose T_common_source;
  FineRegistrationResult registration;
  LoopPrior prior = {};
  SubmapPtr target = nullptr, source = nullptr;

  double movedTranslation() const;  ///< m, from the guess to the result
  double movedRotation() const;     ///< degrees
  /// Standard deviations of the result from the prior; 0 without one.
  double deviation(const DriftConfig& config) const;
  /// rivalShare() within what the prior allows and `radius`, m; 0 if not known.
  double ambiguity(double radius) const;
};

/// How a value has to compare with a limit.
enum class Bound { above, at_least, at_most };

/// What a gate measured of a pair, and what it requires of that.
struct GateMeasurement {
  double value = 0.0;
  Bound bound = Bound::above;
  double limit = 0.0;
  std::string unit;

  /// False for NaN.
  bool isWithin() const;
};

/// What the gates decided on a pair.
struct LoopVerdict {
  std::string gate;             ///< that rejected the pair; empty: accepted
  GateMeasurement measurement;  ///< of that gate

  bool isAccepted() const { return gate.empty(); }
  /// "accepted", or the name of the gate.
  std::string outcome() const { return isAccepted() ? "accepted" : gate; }
  /// "fitness 0.18 <= 0.25"; empty if accepted.
  std::string reason() const;
};

/// The pairs of two local maps that passed all gates so far, and how many each gate rejected.
struct RemainingPairs {
  std::vector<RegisteredPair> pairs;
  std::map<std::string, std::size_t> rejected;
};

/// One criterion that registered pairs have to meet.
struct Gate {
  std::string name;  ///< as tables, JSON and rviz say it
  /// One measurement for each remaining pair.
  std::function<std::vector<GateMeasurement>(const RemainingPairs&)> measure;
  bool only_lone = false;  ///< looks at a pair only if it is the last one that remains
};

/// A gate that looks at each pair by itself.
Gate gateOfEach(std::string name, std::function<GateMeasurement(const RegisteredPair&)> measure);

/// The same gate, but for a registration that no other one of its local maps can confirm.
Gate onlyLone(Gate gate);

/// Shows all pairs of two local maps to the gates, in order; a pair that one rejects is not shown
/// to the next. @return one verdict for each pair.
std::vector<LoopVerdict> judge(const std::vector<RegisteredPair>& pairs,
                               const std::vector<Gate>& gates);

}  // namespace revisit_slam
