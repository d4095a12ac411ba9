// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/gnss_track.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "revisit_slam/priors/covariance_check.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

constexpr double kLongestGap = 1.0;       // s, between scans over which is interpolated
constexpr double kLongestSilence = 10.0;  // s, of scans without a position
/// Share of the variance of the one before of which a position is used however near it is.
constexpr double kMuchBetter = 0.25;
constexpr std::size_t kMostWaiting = 3000;  // a minute at 50 Hz: scans have stopped

Pose interpolated(const Pose& from, const Pose& to, double share) {
  return boxplus(from, share * log(from.inverse() * to));
}

}  // namespace

void GnssTrack::take(GnssReading reading) {
  ++account_.received;
  was_heard_ = true;
  reading.stamp = reading.stamp.plusSeconds(config_.time_offset);
  if (!scans_.empty() && reading.stamp.plusSeconds(config_.max_delay) <= scans_.back().stamp)
    return drop("too late");
  const auto place = std::lower_bound(
      waiting_.begin(), waiting_.end(), reading.stamp,
      [](const GnssReading& waiting, Stamp stamp) { return waiting.stamp < stamp; });
  if (place != waiting_.end() && place->stamp == reading.stamp) return drop("duplicate stamp");
  const double variance = config_.min_deviation * config_.min_deviation;
  reading.covariance_enu.diagonal() = reading.covariance_enu.diagonal().cwiseMax(variance);
  reading.covariance_enu = withPossibleCorrelations(reading.covariance_enu);
  waiting_.insert(place, std::move(reading));
  if (waiting_.size() <= kMostWaiting) return;
  waiting_.pop_front();
  drop("no scans");
}

void GnssTrack::countDropped(const std::string& reason) {
  ++account_.received;
  drop(reason);
}

void GnssTrack::observe(ScanId id, Stamp stamp, const Pose& T_odom_base) {
  if (!isConnected()) return;
  if (!heard_at_ || std::exchange(was_heard_, false)) heard_at_ = stamp;
  account_.is_silent = secondsBetween(*heard_at_, stamp) > kLongestSilence;
  const bool repeats = !scans_.empty() && scans_.back().id == id;
  scans_.push_back({id, stamp, T_odom_base, repeats ? scans_.back().T_odom_first : T_odom_base});
  const Stamp oldest = waiting_.empty() ? stamp : std::min(stamp, waiting_.front().stamp);
  const Stamp needed = std::min(oldest, stamp.plusSeconds(-config_.max_delay));
  while (scans_.size() > 2 && scans_[1].stamp <= needed) scans_.pop_front();
}

std::vector<GnssFix> GnssTrack::due() {
  std::vector<GnssFix> fixes;
  while (!waiting_.empty() && !scans_.empty() &&
         waiting_.front().stamp.plusSeconds(config_.max_delay) <= scans_.back().stamp) {
    if (const std::optional<GnssFix> fix = tie(waiting_.front())) fixes.push_back(*fix);
    waiting_.pop_front();
  }
  return fixes;
}

/// To the last scan that is not after it.
std::optional<GnssFix> GnssTrack::tie(const GnssReading& reading) {
  const auto after =
      std::upper_bound(scans_.begin(), scans_.end(), reading.stamp,
                       [](Stamp stamp, const Placed& scan) { return stamp < scan.stamp; });
  if (after == scans_.begin()) return drop("before the first scan"), std::nullopt;
  if (after == scans_.end()) return drop("no scan after it"), std::nullopt;
  const Placed& from = *std::prev(after);
  const double gap = secondsBetween(from.stamp, after->stamp);
  if (gap > kLongestGap) return drop("scans are missing around it"), std::nullopt;
  const double share = secondsBetween(from.stamp, reading.stamp) / gap;
  const Eigen::Vector3d p_odom =
      interpolated(from.T_odom_base, after->T_odom_base, share) * reading.p_base;
  const double variance = reading.covariance_enu.trace();
  const bool is_near = last_odom_ && (p_odom - *last_odom_).norm() < config_.spacing;
  if (is_near && variance > kMuchBetter * last_variance_)
    return drop("nearer than gnss/spacing"), std::nullopt;
  last_odom_ = p_odom;
  last_variance_ = variance;
  ++account_.used;
  return GnssFix{reading.stamp, from.id, from.T_odom_first.inverse() * p_odom, reading.position,
                 reading.covariance_enu};
}

void GnssTrack::restart() {
  waiting_.clear();
  scans_.clear();
  last_odom_.reset();
  was_heard_ = false;
  heard_at_.reset();
  account_ = {};
}

}  // namespace revisit_slam
