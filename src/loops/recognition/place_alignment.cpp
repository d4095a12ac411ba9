// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_alignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>

namespace revisit_slam {
namespace {

/// A pair with the direction (cosine, sine) of its turn: what is asked of thousands of samples does
/// without a trigonometric function.
struct DirectedPair {
  Eigen::Vector2d source, target, turn;
  double angle;  ///< rad, of the turn; in [0, 2 pi), or a turn more or less
};
using Pairs = std::vector<DirectedPair>;

Pairs withDirections(const std::vector<PointPair>& pairs) {
  Pairs result;
  result.reserve(pairs.size());
  for (const PointPair& pair : pairs)
    result.push_back({pair.source,
                      pair.target,
                      {std::cos(pair.turn), std::sin(pair.turn)},
                      pair.turn - 2.0 * M_PI * std::floor(pair.turn / (2.0 * M_PI))});
  return result;
}

/// The cosine and sine of the angle from a to b, times their lengths.
Eigen::Vector2d turnBetween(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return {a.dot(b), a.x() * b.y() - a.y() * b.x()};
}

/// Least squares in the plane: the rotation is the angle of the summed products of the centred
/// points, taken as complex numbers (Horn 1987, in two dimensions).
template <typename SomePairs>
Eigen::Isometry2d leastSquares(const SomePairs& pairs) {
  Eigen::Vector2d source = Eigen::Vector2d::Zero(), target = Eigen::Vector2d::Zero();
  for (const DirectedPair& pair : pairs) {
    source += pair.source / static_cast<double>(pairs.size());
    target += pair.target / static_cast<double>(pairs.size());
  }
  Eigen::Vector2d turn = Eigen::Vector2d::Zero();
  for (const DirectedPair& pair : pairs)
    turn += turnBetween(pair.source - source, pair.target - target);
  const double length = turn.norm();
  turn = length > 0.0 ? Eigen::Vector2d(turn / length) : Eigen::Vector2d::UnitX();
  Eigen::Isometry2d T = Eigen::Isometry2d::Identity();
  T.linear() << turn.x(), -turn.y(), turn.y(), turn.x();
  T.translation() = target - T.linear() * source;
  return T;
}

double squaredError(const Eigen::Isometry2d& T, const DirectedPair& pair) {
  return (T * pair.source - pair.target).squaredNorm();
}

/// What makes a pair agree with an alignment.
class InlierTest {
 public:
  explicit InlierTest(const PlanarAlignmentConfig& config)
      : squared_radius_(config.inlier_radius * config.inlier_radius),
        least_cosine_(config.max_turn < M_PI ? std::cos(config.max_turn) : kAnyTurn) {}

  bool operator()(const Eigen::Isometry2d& T, const DirectedPair& pair) const {
    return squaredError(T, pair) < squared_radius_ && turnsLike(pair, T.linear().col(0), 1.0);
  }

  /// turn: of that length
  bool turnsLike(const DirectedPair& pair, const Eigen::Vector2d& turn, double length) const {
    return pair.turn.dot(turn) >= least_cosine_ * length;
  }

 private:
  static constexpr double kAnyTurn = -2.0;  // no cosine is as small, however rounded
  double squared_radius_, least_cosine_;
};

/// Whether the squared lengths are above that of `play` and the lengths differ by less (squared
/// twice: no roots to draw).
bool areOfLikeLength(double aa, double bb, double play) {
  const double sum = aa + bb - play * play;
  return std::min(aa, bb) > play * play && sum * sum < 4.0 * aa * bb;
}

/// Whether one rigid motion can bring both pairs within the radius and has their turn, and whether
/// they are far enough from each other to tell.
bool fitTogether(const DirectedPair& a, const DirectedPair& b, const InlierTest& agree,
                 double inlier_radius) {
  const Eigen::Vector2d source = b.source - a.source, target = b.target - a.target;
  const double ss = source.squaredNorm(), tt = target.squaredNorm();
  if (!areOfLikeLength(ss, tt, 2.0 * inlier_radius)) return false;
  const Eigen::Vector2d turn = turnBetween(source, target);
  const double length = std::sqrt(ss * tt);
  return agree.turnsLike(a, turn, length) && agree.turnsLike(b, turn, length);
}

Pairs inliersOf(const Eigen::Isometry2d& T, const Pairs& pairs, const InlierTest& agree) {
  Pairs inliers;
  for (const DirectedPair& pair : pairs)
    if (agree(T, pair)) inliers.push_back(pair);
  return inliers;
}

/// Pairs in the order of their turns, which all go round once: what is within reach of one of them
/// lies side by side.
class TurnOrder {
 public:
  using Iterator = Pairs::const_iterator;
  struct Range {
    Iterator first, last;
    Iterator begin() const { return first; }
    Iterator end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };

  explicit TurnOrder(const Pairs& pairs) : count_(pairs.size()) {
    std::vector<std::pair<double, std::size_t>> order;  // lighter to sort than the pairs
    order.reserve(count_);
    for (const DirectedPair& pair : pairs) order.emplace_back(pair.angle, order.size());
    std::sort(order.begin(), order.end());
    thrice_.reserve(3 * count_);
    for (const double turn : {-2.0 * M_PI, 0.0, 2.0 * M_PI})
      for (const auto& [angle, index] : order) {
        thrice_.push_back(pairs[index]);
        thrice_.back().angle += turn;
      }
  }

  Range all() const { return {at(count_), at(2 * count_)}; }

  /// Of each of `all` those that follow it and turn by at most `reach` more.
  std::vector<Range> following(double reach) const {
    std::vector<Range> ranges;
    ranges.reserve(count_);
    Iterator end = at(count_);
    for (Iterator pair = all().begin(); pair != all().end(); ++pair) {
      const Iterator last = pair + static_cast<std::ptrdiff_t>(count_);
      end = std::max(end, pair + 1);
      while (end != last && end->angle <= pair->angle + reach) ++end;
      ranges.push_back({pair + 1, end});
    }
    return ranges;
  }

  /// Those that turn by at most `reach` more or less than this one of `all`, each once.
  Range around(Iterator pair, double reach) const {
    if (reach >= M_PI) return all();
    return {std::lower_bound(at(0), pair, pair->angle - reach, isBehind),
            std::upper_bound(pair, at(3 * count_), pair->angle + reach, isBefore)};
  }

 private:
  static bool isBefore(double angle, const DirectedPair& pair) { return angle < pair.angle; }
  static bool isBehind(const DirectedPair& pair, double angle) { return pair.angle < angle; }
  Iterator at(std::size_t i) const { return thrice_.begin() + static_cast<std::ptrdiff_t>(i); }

  std::size_t count_;
  Pairs thrice_;
};

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

/// Samples are two pairs whose turns can both agree with one alignment; with it only those agree
/// that turn by no more than twice the tolerance otherwise than either.
Pairs largestConsensus(const Pairs& pairs, const InlierTest& agree,
                       const PlanarAlignmentConfig& config) {
  const TurnOrder order(pairs);
  const double reach = 2.0 * config.max_turn;
  const std::vector<TurnOrder::Range> seconds = order.following(reach);
  std::size_t samples = 0;
  for (const TurnOrder::Range& range : seconds) samples += range.size();
  SampleChoice choice(samples, config);
  std::ptrdiff_t most = 0;
  Eigen::Isometry2d best = Eigen::Isometry2d::Identity();
  for (const TurnOrder::Range& range : seconds) {
    const auto a = range.first - 1;
    std::optional<TurnOrder::Range> near;
    for (const DirectedPair& b : range) {
      if (!choice.next() || !fitTogether(*a, b, agree, config.inlier_radius)) continue;
      if (!near) near = order.around(a, reach);
      const Eigen::Isometry2d T = leastSquares(std::array<DirectedPair, 2>{*a, b});
      const auto inliers = std::count_if(near->begin(), near->end(),
                                         [&](const DirectedPair& pair) { return agree(T, pair); });
      if (inliers <= most) continue;
      most = inliers;
      best = T;
    }
  }
  return most > 0 ? inliersOf(best, pairs, agree) : Pairs{};
}

/// As long as more pairs agree with the estimate from all that agreed before.
Pairs grown(Pairs inliers, const Pairs& pairs, const InlierTest& agree) {
  for (;;) {
    Pairs again = inliersOf(leastSquares(inliers), pairs, agree);
    if (again.size() <= inliers.size()) return inliers;
    inliers = std::move(again);
  }
}

/// How many can be taken, in order, so that all are as far from each other.
int countSeparate(const Pairs& pairs, double separation) {
  std::vector<Eigen::Vector2d> taken;
  for (const DirectedPair& pair : pairs) {
    const auto is_near = [&](const Eigen::Vector2d& other) {
      return (other - pair.source).norm() < separation;
    };
    if (std::none_of(taken.begin(), taken.end(), is_near)) taken.push_back(pair.source);
  }
  return static_cast<int>(taken.size());
}

double rmsError(const Eigen::Isometry2d& T, const Pairs& pairs) {
  double sum = 0.0;
  for (const DirectedPair& pair : pairs) sum += squaredError(T, pair);
  return std::sqrt(sum / static_cast<double>(pairs.size()));
}

}  // namespace

PlanarAlignment alignPlanar(const std::vector<PointPair>& point_pairs,
                            const PlanarAlignmentConfig& config) {
  if (point_pairs.size() < 2) return {};
  const Pairs pairs = withDirections(point_pairs);
  const InlierTest agree(config);
  const Pairs consensus = largestConsensus(pairs, agree, config);
  if (consensus.empty()) return {};
  const Pairs inliers = grown(consensus, pairs, agree);
  const Eigen::Isometry2d T_target_source = leastSquares(inliers);
  return {T_target_source, countSeparate(inliers, config.separation),
          rmsError(T_target_source, inliers)};
}

}  // namespace revisit_slam
