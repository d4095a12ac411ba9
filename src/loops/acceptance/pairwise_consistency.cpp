// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/pairwise_consistency.h"

#include <cstddef>
#include <utility>

namespace revisit_slam {
namespace {

constexpr double kDegrees = 180.0 / M_PI;

/// Of two registrations, with what the odometry between them allows.
struct Difference {
  GateMeasurement translation, rotation;

  bool isWithin() const { return translation.isWithin() && rotation.isWithin(); }
};

Difference differenceOf(const RegisteredPair& a, const RegisteredPair& b,
                        const PairwiseConsistencyConfig& config) {
  const Pose T_tb_ta = b.T_common_target.inverse() * a.T_common_target;
  const Pose T_sa_sb = a.T_common_source.inverse() * b.T_common_source;
  const Pose error = (T_tb_ta * a.registration.T_target_source * T_sa_sb).inverse() *
                     b.registration.T_target_source;
  const double apart = T_tb_ta.translation.norm() + T_sa_sb.translation.norm();
  return {{error.translation.norm(), Bound::at_most,
           config.translation + config.translation_drift * apart, "m"},
          {error.angle() * kDegrees, Bound::at_most,
           config.rotation + config.rotation_drift * apart, "deg"}};
}

/// How many are consistent with a pair, itself included, and how well they fit.
using Support = std::pair<std::size_t, double>;

Support supportOf(const RegisteredPair& pair, const std::vector<RegisteredPair>& pairs,
                  const PairwiseConsistencyConfig& config) {
  Support support{0, 0.0};
  for (const RegisteredPair& other : pairs) {
    if (!areConsistent(pair, other, config)) continue;
    ++support.first;
    support.second += other.registration.fitness;
  }
  return support;
}

struct Centre {
  std::size_t index = 0;
  Support support{0, 0.0};
};

/// The pair that most are consistent with.
Centre centreOf(const std::vector<RegisteredPair>& pairs, const PairwiseConsistencyConfig& config) {
  Centre centre;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Support support = supportOf(pairs[i], pairs, config);
    if (support > centre.support) centre = {i, support};
  }
  return centre;
}

std::vector<GateMeasurement> measureConsistency(const std::vector<RegisteredPair>& pairs,
                                                std::size_t others,
                                                const PairwiseConsistencyConfig& config) {
  const Centre centre = centreOf(pairs, config);
  const double all = static_cast<double>(pairs.size() + others);
  const GateMeasurement share{static_cast<double>(centre.support.first) / all, Bound::above, 0.5,
                              ""};
  std::vector<GateMeasurement> measurements(pairs.size(), share);
  for (std::size_t i = 0; i < pairs.size() && share.isWithin(); ++i) {
    const Difference difference = differenceOf(pairs[centre.index], pairs[i], config);
    if (difference.isWithin()) continue;
    measurements[i] =
        difference.translation.isWithin() ? difference.rotation : difference.translation;
  }
  return measurements;
}

}  // namespace

bool areConsistent(const RegisteredPair& a, const RegisteredPair& b,
                   const PairwiseConsistencyConfig& config) {
  return differenceOf(a, b, config).isWithin();
}

Gate consistencyGate(const PairwiseConsistencyConfig& config, std::vector<std::string> opponents) {
  return {"consistency", [config, opponents](const RemainingPairs& remaining) {
            std::size_t others = 0;
            for (const std::string& gate : opponents) {
              const auto rejected = remaining.rejected.find(gate);
              if (rejected != remaining.rejected.end()) others += rejected->second;
            }
            return measureConsistency(remaining.pairs, others, config);
          }};
}

}  // namespace revisit_slam
