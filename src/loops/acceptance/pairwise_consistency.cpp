// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/pairwise_consistency.h"

#include <algorithm>
#include <utility>

namespace revisit_slam {
namespace {

constexpr double kDegrees = 180.0 / M_PI;

/// How many are consistent with a pair, itself included, and how well they fit.
std::pair<std::size_t, double> supportOf(const RegisteredPair& pair,
                                         const std::vector<RegisteredPair>& pairs,
                                         const PairwiseConsistencyConfig& config) {
  std::pair<std::size_t, double> support{0, 0.0};
  for (const RegisteredPair& other : pairs) {
    if (!areConsistent(pair, other, config)) continue;
    ++support.first;
    support.second += other.fitness;
  }
  return support;
}

}  // namespace

bool areConsistent(const RegisteredPair& a, const RegisteredPair& b,
                   const PairwiseConsistencyConfig& config) {
  const Pose T_tb_ta = b.T_common_target.inverse() * a.T_common_target;
  const Pose T_sa_sb = a.T_common_source.inverse() * b.T_common_source;
  const Pose error = (T_tb_ta * a.T_target_source * T_sa_sb).inverse() * b.T_target_source;
  const double apart = T_tb_ta.translation.norm() + T_sa_sb.translation.norm();
  return error.translation.norm() <= config.translation + config.translation_drift * apart &&
         error.angle() * kDegrees <= config.rotation + config.rotation_drift * apart;
}

std::vector<bool> majority(const std::vector<RegisteredPair>& pairs, std::size_t others,
                           const PairwiseConsistencyConfig& config) {
  std::vector<bool> belongs(pairs.size(), false);
  std::pair<std::size_t, double> most{0, 0.0};
  std::size_t centre = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto support = supportOf(pairs[i], pairs, config);
    if (support <= most) continue;
    most = support;
    centre = i;
  }
  if (2 * most.first <= pairs.size() + others) return belongs;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    belongs[i] = areConsistent(pairs[centre], pairs[i], config);
  return belongs;
}

}  // namespace revisit_slam
