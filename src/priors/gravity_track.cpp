// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/gravity_track.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace revisit_slam {
namespace {

constexpr double kGravity = 9.81;             // m/s^2
constexpr double kLargestError = 0.5;         // m/s^2: gravity itself varies by 0.03, biases by 0.2
constexpr double kLongestGap = 0.5;           // s, between scans over which is interpolated
constexpr double kClock = 1.0;                // s: what is older is of a clock that was set back
constexpr double kLongestSilence = 0.25;      // s, of the unit within a window
constexpr std::size_t kMostWaiting = 30'000;  // half a minute of a fast unit: scans have stopped

}  // namespace

void GravityTrack::take(const ImuReading& reading) {
  if (!config_.enabled || !reading.acceleration) return;
  if (!readings_.empty() && reading.stamp <= readings_.back().stamp) {
    if (secondsBetween(reading.stamp, readings_.back().stamp) < kClock) return;
    readings_.clear();
  }
  readings_.push_back(reading);
  if (readings_.size() > kMostWaiting) readings_.pop_front();
}

std::optional<GravityDirection> GravityTrack::observe(ScanId id, Stamp stamp,
                                                      const Pose& T_odom_base) {
  if (!config_.enabled || readings_.empty()) return std::nullopt;
  if (!scans_.empty() && secondsBetween(scans_.back().stamp, stamp) > kLongestGap) {
    ++account_.received;
    ++account_.dropped["scans are missing"];
    scans_.clear();
  }
  const bool repeats = newest_ && newest_->id == id;
  newest_ = {id, stamp, T_odom_base, repeats ? newest_->R_odom_first : T_odom_base.rotation};
  scans_.push_back(*newest_);
  const bool is_whole = secondsBetween(scans_.front().stamp, stamp) >= config_.window;
  std::optional<GravityDirection> direction;
  if (is_whole) {
    direction = endWindow();
    scans_.erase(scans_.begin(), std::prev(scans_.end()));  // the next one begins with its end
  }
  const Stamp begin = scans_.front().stamp;
  while (readings_.size() > 1 && readings_[1].stamp < begin) readings_.pop_front();
  return direction;
}

std::optional<GravityDirection> GravityTrack::endWindow() {
  ++account_.received;
  const std::size_t middle = middleScan();
  const auto drop = [&](const char* reason) { return ++account_.dropped[reason], std::nullopt; };
  if (middle == 0 || middle + 1 == scans_.size()) return drop("too few scans");
  if (last_ && *last_ == scans_[middle].id) return drop("at rest");
  const std::optional<Eigen::Vector3d> force = meanForce(middle);
  if (!force) return drop("accelerations are missing");
  const Eigen::Vector3d up_odom = *force - acceleration(middle);
  if (std::abs(up_odom.norm() - kGravity) > kLargestError)
    return drop("not of the size of gravity");
  ++account_.used;
  last_ = scans_[middle].id;
  return GravityDirection{*last_, scans_[middle].R_odom_first.conjugate() * up_odom.normalized()};
}

std::size_t GravityTrack::middleScan() const {
  const double half = 0.5 * secondsBetween(scans_.front().stamp, scans_.back().stamp);
  const auto middle = std::find_if(scans_.begin(), scans_.end(), [&](const Placed& scan) {
    return secondsBetween(scans_.front().stamp, scan.stamp) >= half;
  });
  return static_cast<std::size_t>(middle - scans_.begin());
}

/// int w R_odom_base f dt, linear from reading to reading. Nothing where many are missing.
std::optional<Eigen::Vector3d> GravityTrack::meanForce(std::size_t middle) const {
  const Stamp begin = scans_.front().stamp, end = scans_.back().stamp;
  const double rise = secondsBetween(begin, scans_[middle].stamp);
  const double fall = secondsBetween(scans_[middle].stamp, end);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0.0;
  Stamp before = begin;
  Eigen::Vector3d weighted_before = Eigen::Vector3d::Zero();
  double weight_before = 0.0;
  for (const ImuReading& reading : readings_) {
    if (reading.stamp < begin) continue;
    if (reading.stamp > end) break;
    if (secondsBetween(before, reading.stamp) > kLongestSilence) return std::nullopt;
    const double since = secondsBetween(begin, reading.stamp);
    const double weight = since < rise ? since / rise : (rise + fall - since) / fall;
    const Eigen::Vector3d weighted =
        weight * (orientationAt(reading.stamp) * *reading.acceleration);
    const double seconds = secondsBetween(before, reading.stamp);
    sum += seconds * (weighted + weighted_before);
    weights += seconds * (weight + weight_before);
    before = reading.stamp;
    weighted_before = weighted;
    weight_before = weight;
  }
  if (secondsBetween(before, end) > kLongestSilence) return std::nullopt;
  return Eigen::Vector3d(sum / weights);
}

/// R_odom_base between two scans of the window.
Eigen::Quaterniond GravityTrack::orientationAt(Stamp stamp) const {
  const auto to = std::lower_bound(std::next(scans_.begin()), std::prev(scans_.end()), stamp,
                                   [](const Placed& scan, Stamp at) { return scan.stamp < at; });
  const Placed &a = *std::prev(to), &b = *to;
  const double share = secondsBetween(a.stamp, stamp) / secondsBetween(a.stamp, b.stamp);
  return a.T_odom_base.rotation.slerp(share, b.T_odom_base.rotation);
}

/// Of the unit, the mean with the weights w.
Eigen::Vector3d GravityTrack::acceleration(std::size_t middle) const {
  const Eigen::Vector3d& p_base = readings_.back().p_base;
  const Placed &a = scans_.front(), &b = scans_[middle], &c = scans_.back();
  const Eigen::Vector3d p_a = a.T_odom_base * p_base, p_b = b.T_odom_base * p_base,
                        p_c = c.T_odom_base * p_base;
  return 2.0 / secondsBetween(a.stamp, c.stamp) *
         ((p_c - p_b) / secondsBetween(b.stamp, c.stamp) -
          (p_b - p_a) / secondsBetween(a.stamp, b.stamp));
}

void GravityTrack::restart() {
  scans_.clear();
  newest_.reset();
  last_.reset();
  account_ = {};
}

}  // namespace revisit_slam
