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
  if (!isSettled()) return kNoFit;
  const double sudden = usual_ - kSudden * std::max(deviation_, kLeastDeviation);
  return std::max({kNoFit, config_.good * usual_, sudden});
}

PoseVerdict FitJudge::judge(double explained, std::size_t points, double jump) const {
  const bool has_map = scans_ > 0;
  if (!has_map || config_.good == 0.0) return PoseVerdict::good;
  const bool has_jumped = config_.jump > 0.0 && jump > config_.jump;
  if (explained >= leastOfGood()) return has_jumped ? PoseVerdict::poor : PoseVerdict::good;
  const double lost = isSettled() ? config_.lost * usual_ : 0.0;
  return explained < lost && points >= kTellingPoints ? PoseVerdict::lost : PoseVerdict::poor;
}

bool FitJudge::isUsual(double explained) const {
  return explained >= config_.good * usual_;
}

/// Poor ones count less: where surroundings have changed they become what is usual.
void FitJudge::observe(double explained, PoseVerdict verdict) {
  ++scans_;
  if (scans_ == 1) return;
  const bool is_worse = verdict != PoseVerdict::good || explained < usual_;
  const double weight = is_worse ? 0.2 * kNewest : kNewest;
  const double share = std::max(weight, isSettled() ? 0.0 : 1.0 / (scans_ - 1));
  if (scans_ > 2) deviation_ += share * (std::abs(explained - usual_) - deviation_);
  usual_ += share * (explained - usual_);
}

}  // namespace revisit_slam
