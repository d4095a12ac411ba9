// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/gate.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "revisit_slam/loops/acceptance/ambiguity.h"

namespace revisit_slam {
namespace {

constexpr double kDegrees = 180.0 / M_PI;
/// Rivals of a registration lie within so many standard deviations of the prior.
constexpr double kDeviations = 3.0;

Pose movedBy(const RegisteredPair& pair) {
  const Pose guess = pair.T_common_target.inverse() * pair.T_common_source;
  return guess.inverse() * pair.registration.T_target_source;
}

/// How a value that is not within the bound compares with the limit.
const char* violationOf(Bound bound) {
  switch (bound) {
    case Bound::above:
      return "<=";
    case Bound::at_least:
      return "<";
    case Bound::at_most:
      return ">";
  }
  return "?";
}

std::string numberText(double value, const std::string& unit) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return unit.empty() ? text : text + (" " + unit);
}

}  // namespace

double RegisteredPair::movedTranslation() const {
  return movedBy(*this).translation.norm();
}

double RegisteredPair::movedRotation() const {
  return movedBy(*this).angle() * kDegrees;
}

double RegisteredPair::deviation(const DriftConfig& config) const {
  return prior.deviation(registration.T_target_source, config);
}

double RegisteredPair::ambiguity(double radius) const {
  if (!source || !target) return 0.0;
  return rivalShare(*source, *target, registration.T_target_source,
                    std::min(radius, kDeviations * prior.drift.plane));
}

bool GateMeasurement::isWithin() const {
  switch (bound) {
    case Bound::above:
      return value > limit;
    case Bound::at_least:
      return value >= limit;
    case Bound::at_most:
      return value <= limit;
  }
  return false;
}

std::string LoopVerdict::reason() const {
  if (isAccepted()) return "";
  return gate + " " + numberText(measurement.value, measurement.unit) + " " +
         violationOf(measurement.bound) + " " + numberText(measurement.limit, measurement.unit);
}

Gate gateOfEach(std::string name, std::function<GateMeasurement(const RegisteredPair&)> measure) {
  return {std::move(name), [measure = std::move(measure)](const RemainingPairs& remaining) {
            std::vector<GateMeasurement> measurements;
            for (const RegisteredPair& pair : remaining.pairs)
              measurements.push_back(measure(pair));
            return measurements;
          }};
}

Gate onlyLone(Gate gate) {
  gate.name = "lone " + gate.name;
  gate.only_lone = true;
  return gate;
}

std::vector<LoopVerdict> judge(const std::vector<RegisteredPair>& pairs,
                               const std::vector<Gate>& gates) {
  std::vector<LoopVerdict> verdicts(pairs.size());
  RemainingPairs remaining;
  for (const Gate& gate : gates) {
    std::vector<std::size_t> indices;
    remaining.pairs.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!verdicts[i].isAccepted()) continue;
      indices.push_back(i);
      remaining.pairs.push_back(pairs[i]);
    }
    if (gate.only_lone && indices.size() > 1) continue;
    const std::vector<GateMeasurement> measurements = gate.measure(remaining);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (measurements[i].isWithin()) continue;
      verdicts[indices[i]] = {gate.name, measurements[i]};
      ++remaining.rejected[gate.name];
    }
  }
  return verdicts;
}

}  // namespace revisit_slam
