// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/enu_alignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kEnds = 24;     // pairs that hypotheses are made of
constexpr std::size_t kVoters = 200;  // pairs that these are judged by
constexpr int kRefinements = 10;
constexpr double kUnlike = 4.0;  // standard deviations between lengths that are not the same

using Pairs = std::vector<PositionPair>;

/// Evenly chosen, the first and the last among them.
Pairs chosenFrom(const Pairs& pairs, std::size_t most) {
  if (pairs.size() <= most) return pairs;
  Pairs chosen;
  for (std::size_t i = 0; i < most; ++i)
    chosen.push_back(pairs[i * (pairs.size() - 1) / (most - 1)]);
  return chosen;
}

double chi2Of(const PositionPair& pair, const Pose& T_map_enu) {
  const Eigen::Vector2d e = (T_map_enu * pair.p_enu - pair.p_map).head<2>();
  return e.squaredNorm() / (pair.deviation * pair.deviation);
}

double costOf(const Pairs& pairs, const Pose& T_map_enu, double scale) {
  double cost = 0.0;
  for (const PositionPair& pair : pairs)
    cost += std::log1p(chi2Of(pair, T_map_enu) / (scale * scale));
  return cost;
}

/// Least squares with these weights: yaw and horizontal translation, then height.
EnuAlignment weightedAlignment(const Pairs& pairs, const std::vector<double>& weights) {
  double sum = 0.0, sum_up = 0.0, up = 0.0;
  Eigen::Vector2d mean_map = Eigen::Vector2d::Zero(), mean_enu = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double weight = weights[i] / (pairs[i].deviation * pairs[i].deviation);
    const double weight_up =
        weights[i] / (pairs[i].vertical_deviation * pairs[i].vertical_deviation);
    sum += weight;
    sum_up += weight_up;
    mean_map += weight * pairs[i].p_map.head<2>();
    mean_enu += weight * pairs[i].p_enu.head<2>();
    up += weight_up * (pairs[i].p_map.z() - pairs[i].p_enu.z());
  }
  mean_map /= sum;
  mean_enu /= sum;
  double along = 0.0, across = 0.0, spread = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double weight = weights[i] / (pairs[i].deviation * pairs[i].deviation);
    const Eigen::Vector2d a = pairs[i].p_enu.head<2>() - mean_enu;
    const Eigen::Vector2d b = pairs[i].p_map.head<2>() - mean_map;
    along += weight * a.dot(b);
    across += weight * (a.x() * b.y() - a.y() * b.x());
    spread += weight * b.squaredNorm();
  }
  EnuAlignment aligned;
  aligned.T_map_enu.rotation = expSO3({0.0, 0.0, std::atan2(across, along)});
  const Eigen::Vector3d turned =
      aligned.T_map_enu.rotation * Eigen::Vector3d(mean_enu.x(), mean_enu.y(), 0.0);
  aligned.T_map_enu.translation << mean_map - turned.head<2>(), up / sum_up;
  aligned.yaw_deviation = 1.0 / std::sqrt(std::max(spread, 1e-300));
  return aligned;
}

/// That of two pairs, unless their distances in both frames differ, or they are at one place.
std::optional<Pose> alignmentOf(const PositionPair& a, const PositionPair& b) {
  const double deviation = std::hypot(a.deviation, b.deviation);
  const double in_map = (b.p_map - a.p_map).head<2>().norm();
  const double in_enu = (b.p_enu - a.p_enu).head<2>().norm();
  if (std::min(in_map, in_enu) < deviation || std::abs(in_map - in_enu) > kUnlike * deviation)
    return std::nullopt;
  return weightedAlignment({a, b}, {1.0, 1.0}).T_map_enu;
}

std::optional<Pose> bestOfTwoPairs(const Pairs& pairs, double scale) {
  const Pairs ends = chosenFrom(pairs, kEnds), voters = chosenFrom(pairs, kVoters);
  std::optional<Pose> best;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const std::optional<Pose> T_map_enu = alignmentOf(ends[i], ends[j]);
      if (!T_map_enu) continue;
      const double cost = costOf(voters, *T_map_enu, scale);
      if (cost >= lowest) continue;
      lowest = cost;
      best = T_map_enu;
    }
  }
  return best;
}

}  // namespace

std::optional<EnuAlignment> alignToEnu(const std::vector<PositionPair>& pairs,
                                       double kernel_scale) {
  if (pairs.size() < 3) return std::nullopt;
  const std::optional<Pose> start = bestOfTwoPairs(pairs, kernel_scale);
  if (!start) return std::nullopt;
  EnuAlignment aligned{*start, 0.0};
  for (int i = 0; i < kRefinements; ++i) {
    std::vector<double> weights;
    weights.reserve(pairs.size());
    for (const PositionPair& pair : pairs)
      weights.push_back(1.0 /
                        (1.0 + chi2Of(pair, aligned.T_map_enu) / (kernel_scale * kernel_scale)));
    aligned = weightedAlignment(pairs, weights);
  }
  return aligned;
}

}  // namespace revisit_slam
