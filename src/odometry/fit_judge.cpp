// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/fit_judge.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam {
namespace {

/// The first scans of a map leave much of the next ones unexplained.
constexpr std::uint32_t kSettlingScans = 5;
/// Less than this is no fit, whatever was before: half of what the map explains at least of scans
/// in right places.
constexpr double kNoFit = 0.3;
/// So many mean deviations below what is usual the fit has changed suddenly. The deviation is never
/// taken for less than the least: at rest every scan fits alike.
constexpr double kSudden = 8.0;
constexpr double kLeastDeviation = 0.03;
/// With fewer points the sensor is covered rather than somewhere else.
constexpr std::size_t kTellingPoints = 100;
/// Weight of the newest scan in what is usual: the memory is about two seconds at 10 Hz.
constexpr double kNewest = 0.05;

}  // namespace

bool FitJudge::isSettled() const {
  return scans_ > kSettlingScans;
}

double FitJudge::leastOfGood() const {
  if (!isSettled()) return 0.0;
  const double sudden = usual_.explained - kSudden * std::max(deviation_, kLeastDeviation);
  return std::max(config_.good * usual_.explained, sudden);
}

/// Lost where neither what is in one place alone nor the rest fits as usual: who comes from a
/// street to a field has less of the former.
PoseVerdict FitJudge::judge(const Fit& fit, std::size_t points, double jump) const {
  const bool has_map = scans_ > 0;
  if (!has_map || config_.good == 0.0) return PoseVerdict::good;
  const bool fits = fit.anywhere >= kNoFit && fit.explained >= leastOfGood();
  if (fits) return hasJumped(jump) ? PoseVerdict::poor : PoseVerdict::good;
  const bool is_lost = isSettled() && fit.explained < config_.lost * usual_.explained &&
                       fit.anywhere < config_.good * usual_.anywhere;
  return is_lost && points >= kTellingPoints ? PoseVerdict::lost : PoseVerdict::poor;
}

bool FitJudge::isUsual(double anywhere) const {
  return anywhere >= config_.good * usual_.anywhere;
}

/// Poor ones, and such as fit worse, count less: where surroundings have changed they become what
/// is usual, but not at once.
void FitJudge::observe(const Fit& fit, PoseVerdict verdict) {
  ++scans_;
  if (scans_ == 1) return;
  const bool is_worse = verdict != PoseVerdict::good || fit.explained < usual_.explained;
  const double weight = is_worse ? 0.2 * kNewest : kNewest;
  const double share = std::max(weight, isSettled() ? 0.0 : 1.0 / (scans_ - 1));
  if (scans_ > 2) deviation_ += share * (std::abs(fit.explained - usual_.explained) - deviation_);
  usual_.explained += share * (fit.explained - usual_.explained);
  usual_.anywhere += share * (fit.anywhere - usual_.anywhere);
}

}  // namespace revisit_slam
