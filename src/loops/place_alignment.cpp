// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/place_alignment.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace revisit_slam {
namespace {

using Pairs = std::vector<PointPair>;

/// Least squares in the plane: the rotation is the angle of the summed products of the centred
/// points, taken as complex numbers (Horn 1987, in two dimensions).
Eigen::Isometry2d leastSquares(const Pairs& pairs) {
  Eigen::Vector2d source = Eigen::Vector2d::Zero(), target = Eigen::Vector2d::Zero();
  for (const PointPair& pair : pairs) {
    source += pair.source / static_cast<double>(pairs.size());
    target += pair.target / static_cast<double>(pairs.size());
  }
  double along = 0.0, across = 0.0;
  for (const PointPair& pair : pairs) {
    const Eigen::Vector2d s = pair.source - source, t = pair.target - target;
    along += s.dot(t);
    across += s.x() * t.y() - s.y() * t.x();
  }
  Eigen::Isometry2d T = Eigen::Isometry2d::Identity();
  T.linear() = Eigen::Rotation2Dd(std::atan2(across, along)).toRotationMatrix();
  T.translation() = target - T.linear() * source;
  return T;
}

/// For angles within some turns of each other.
bool areAlike(double angle, double other, double tolerance) {
  double difference = std::abs(angle - other);
  while (difference > M_PI) difference = std::abs(difference - 2.0 * M_PI);
  return difference <= tolerance;
}

double squaredError(const Eigen::Isometry2d& T, const PointPair& pair) {
  return (T * pair.source - pair.target).squaredNorm();
}

void findInliers(const Eigen::Isometry2d& T, const Pairs& pairs,
                 const PlanarAlignmentConfig& config, Pairs& inliers) {
  const double turn = Eigen::Rotation2Dd(T.linear()).angle();
  inliers.clear();
  for (const PointPair& pair : pairs)
    if (squaredError(T, pair) < config.inlier_radius * config.inlier_radius &&
        areAlike(pair.turn, turn, config.max_turn))
      inliers.push_back(pair);
}

double directionOf(const Eigen::Vector2d& v) {
  return std::atan2(v.y(), v.x());
}

/// Whether the lengths are above `play` and differ by less (squared twice: no roots to draw).
bool areOfLikeLength(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double play) {
  const double aa = a.squaredNorm(), bb = b.squaredNorm();
  const double sum = aa + bb - play * play;
  return std::min(aa, bb) > play * play && sum * sum < 4.0 * aa * bb;
}

/// Whether one rigid motion can bring both pairs within the radius and has their turn, and whether
/// they are far enough from each other to tell.
bool fitTogether(const PointPair& a, const PointPair& b, const PlanarAlignmentConfig& config) {
  const Eigen::Vector2d source = b.source - a.source, target = b.target - a.target;
  const double play = 2.0 * config.inlier_radius;
  if (!areOfLikeLength(source, target, play)) return false;
  const double turn = directionOf(target) - directionOf(source);
  return areAlike(a.turn, turn, config.max_turn) && areAlike(b.turn, turn, config.max_turn);
}

/// Pairs in the order of their turns, which are in [0, 2 pi), and once more a turn later.
Pairs inTwoTurns(Pairs pairs) {
  for (PointPair& pair : pairs) pair.turn -= 2.0 * M_PI * std::floor(pair.turn / (2.0 * M_PI));
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const PointPair& a, const PointPair& b) { return a.turn < b.turn; });
  const std::size_t count = pairs.size();
  for (std::size_t i = 0; i < count; ++i) {
    pairs.push_back(pairs[i]);
    pairs.back().turn += 2.0 * M_PI;
  }
  return pairs;
}

/// Calls visit(a, b) for all two pairs whose turns can both agree with one alignment.
template <typename Visit>
void forEachSample(const Pairs& twice, const PlanarAlignmentConfig& config, const Visit& visit) {
  const std::size_t count = twice.size() / 2;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < i + count; ++j) {
      if (twice[j].turn - twice[i].turn > 2.0 * config.max_turn) break;
      visit(twice[i], twice[j]);
    }
}

/// Chooses among so many samples those to try: all, or a seeded choice of about `samples`.
class SampleChoice {
 public:
  SampleChoice(std::size_t count, const PlanarAlignmentConfig& config)
      : count_(count), wanted_(static_cast<std::size_t>(config.samples)), random_(config.seed) {}

  bool next() { return count_ <= wanted_ || random_() % count_ < wanted_; }

 private:
  std::size_t count_, wanted_;
  std::minstd_rand random_;
};

Pairs largestConsensus(const Pairs& pairs, const PlanarAlignmentConfig& config) {
  const Pairs twice = inTwoTurns(pairs);
  std::size_t count = 0;
  forEachSample(twice, config, [&](const PointPair&, const PointPair&) { ++count; });
  SampleChoice choice(count, config);
  Pairs best, sample(2), inliers;
  forEachSample(twice, config, [&](const PointPair& a, const PointPair& b) {
    if (!choice.next() || !fitTogether(a, b, config)) return;
    sample = {a, b};
    findInliers(leastSquares(sample), pairs, config, inliers);
    if (inliers.size() > best.size()) std::swap(best, inliers);
  });
  return best;
}

/// As long as more pairs agree with the estimate from all that agreed before.
Pairs grown(Pairs inliers, const Pairs& pairs, const PlanarAlignmentConfig& config) {
  for (;;) {
    Pairs again;
    findInliers(leastSquares(inliers), pairs, config, again);
    if (again.size() <= inliers.size()) return inliers;
    inliers = std::move(again);
  }
}

/// How many can be taken, in order, so that all are as far from each other.
int countSeparate(const Pairs& pairs, double separation) {
  std::vector<Eigen::Vector2d> taken;
  for (const PointPair& pair : pairs) {
    const auto is_near = [&](const Eigen::Vector2d& other) {
      return (other - pair.source).norm() < separation;
    };
    if (std::none_of(taken.begin(), taken.end(), is_near)) taken.push_back(pair.source);
  }
  return static_cast<int>(taken.size());
}

double rmsError(const Eigen::Isometry2d& T, const Pairs& pairs) {
  double sum = 0.0;
  for (const PointPair& pair : pairs) sum += squaredError(T, pair);
  return std::sqrt(sum / static_cast<double>(pairs.size()));
}

}  // namespace

PlanarAlignment alignPlanar(const Pairs& pairs, const PlanarAlignmentConfig& config) {
  if (pairs.size() < 2) return {};
  const Pairs consensus = largestConsensus(pairs, config);
  if (consensus.empty()) return {};
  const Pairs inliers = grown(consensus, pairs, config);
  const Eigen::Isometry2d T_target_source = leastSquares(inliers);
  return {T_target_source, countSeparate(inliers, config.separation),
          rmsError(T_target_source, inliers)};
}

}  // namespace revisit_slam
