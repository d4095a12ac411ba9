// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/fit_judge.h"

#include <algorithm>

namespace revisit_slam {
namespace {

/// The first scans of a map leave much of the next ones unexplained.
constexpr std::uint32_t kSettlingScans = 5;
/// Less than this is no fit, whatever was before.
constexpr double kNoFit = 0.1;
/// With fewer points the sensor is covered rather than somewhere else.
constexpr std::size_t kTellingPoints = 100;
/// Weight of the newest scan in what is usual: the memory is about two seconds at 10 Hz.
constexpr double kNewest = 0.05;

}  // namespace

bool FitJudge::isSettled() const {
  return scans_ > kSettlingScans;
}

PoseVerdict FitJudge::judge(double explained, std::size_t points) const {
  const bool has_map = scans_ > 0;
  if (!has_map || config_.good == 0.0) return PoseVerdict::good;
  const double good = isSettled() ? std::max(kNoFit, config_.good * usual_) : kNoFit;
  const double lost = isSettled() ? config_.lost * usual_ : 0.0;
  if (explained >= good) return PoseVerdict::good;
  return explained < lost && points >= kTellingPoints ? PoseVerdict::lost : PoseVerdict::poor;
}

/// Poor ones count less: where surroundings have changed they become what is usual.
void FitJudge::observe(double explained, PoseVerdict verdict) {
  ++scans_;
  if (scans_ == 1) return;
  const double weight = verdict == PoseVerdict::good ? kNewest : 0.2 * kNewest;
  usual_ += std::max(weight, isSettled() ? 0.0 : 1.0 / (scans_ - 1)) * (explained - usual_);
}

}  // namespace revisit_slam
