// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/localizer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace revisit_slam {
namespace {

/// Scans of a session before the odometry knows the motion that it deskews with: one of a moving
/// base is bent by as much as the base goes during a sweep.
constexpr int kBentScans = 5;

/// deg, headings that are tried about one that is given: ten degrees move what is far by metres.
constexpr double kTurns[] = {0.0, 7.0, -7.0, 14.0, -14.0};

Pose turnedBy(double degrees) {
  return {expSO3({0.0, 0.0, degrees * M_PI / 180.0}), Eigen::Vector3d::Zero()};
}

/// Of a pose with standard deviations of so many metres and degrees along each axis.
Matrix6 diagonal(double metres, double degrees) {
  const double radians = degrees * M_PI / 180.0;
  Matrix6 covariance = Matrix6::Zero();
  covariance.diagonal().head<3>().setConstant(metres * metres);
  covariance.diagonal().tail<3>().setConstant(radians * radians);
  return covariance;
}

bool isBetter(const MapMatch& a, const MapMatch& b) {
  return a.accepted != b.accepted ? a.accepted : a.coherence > b.coherence;
}

}  // namespace

const char* toString(LocalizationState state) {
  switch (state) {
    case LocalizationState::searching:
      return "searching";
    case LocalizationState::candidate:
      return "candidate";
    case LocalizationState::localized:
      return "localized";
    case LocalizationState::lost:
      return "lost";
  }
  return "unknown";
}

Localizer::Localizer(const LocalizerConfig& config, PriorMapPtr map)
    : config_(config),
      map_(std::move(map)),
      matcher_(map_, config.loops.closer, config.information, config.localization.min_overlap),
      places_(map_, config.loops.recognition),
      recent_(config.submap_voxel_size, config.localization.search_length, config.scale),
      window_(config.backend) {
  if (const std::optional<Pose> start = revisit_slam::startPose(config.localization.start, *map_))
    startAt(*start);
}

void Localizer::startAt(const Pose& T_map_base) {
  start_ = T_map_base * T_odom_base_.inverse();
  now_.state = LocalizationState::candidate;
  now_.T_map_odom = *start_;
  covariance_ = PoseCovariance(guessCovariance());
  started_at_ = recent_.travelled();
  attempted_at_ = -config_.localization.interval;  // at once
}

Localization Localizer::add(const InformedScan& informed) {
  const RegisteredScan& scan = *informed.scan;
  const bool rests = has_scans_ && now_.scan == scan.id;
  now_.stamp = scan.stamp;
  now_.attempted = false;
  if (!rests) go(informed);
  if (scans_ > kBentScans && (!rests || start_)) attempt();
  now_.T_map_base = now_.T_map_odom * T_odom_base_;
  now_.since_fix = recent_.travelled() - fixed_at_;
  now_.covariance = covariance_.base();
  return now_;
}

void Localizer::go(const InformedScan& informed) {
  const RegisteredScan& scan = *informed.scan;
  if (!has_scans_ || now_.scan.session != scan.id.session)
    beginSession(informed);
  else
    covariance_.move(T_odom_base_.inverse() * scan.T_odom_base, informed.covariance_motion);
  now_.scan = scan.id;
  T_odom_base_ = scan.T_odom_base;
  window_.add(nodeOf(informed));
  window_.shorten(config_.localization.window);
  if (++scans_ > kBentScans) recent_.insert(scan);
}

/// Of a place that may be as far off as a registration may move it.
Matrix6 Localizer::guessCovariance() const {
  return diagonal(config_.loops.closer.max_translation, config_.loops.closer.max_rotation);
}

/// Another session has an odometry frame of its own; the base has gone on from where it was.
void Localizer::beginSession(const InformedScan& informed) {
  const bool is_first = !has_scans_;
  const bool was_known = has_scans_ && now_.state != LocalizationState::searching;
  const Pose T_map_base = now_.T_map_odom * T_odom_base_;
  recent_ = RecentMap(config_.submap_voxel_size, config_.localization.search_length, config_.scale);
  window_ = PoseWindow(config_.backend);
  hypotheses_.clear();
  fixed_at_ = searched_at_ = started_at_ = 0.0;
  scans_ = 0;
  attempted_at_ = -config_.localization.interval;  // at once
  has_scans_ = true;
  T_odom_base_ = informed.scan->T_odom_base;
  if (is_first && start_) now_.T_map_odom = *start_ * T_odom_base_.inverse();
  if (was_known) now_.T_map_odom = T_map_base * T_odom_base_.inverse();
  if (start_) start_ = now_.T_map_odom;
  if (now_.state == LocalizationState::localized) now_.state = LocalizationState::lost;
}

bool Localizer::isDue(double& last, double interval) const {
  if (recent_.travelled() - last < interval) return false;
  last = recent_.travelled();
  return true;
}

void Localizer::attempt() {
  const LocalizationConfig& config = config_.localization;
  // Whoever has given a pose waits for it.
  const bool hurries = start_ && recent_.travelled() - started_at_ < config.open_length;
  if (!isDue(attempted_at_, hurries ? 0.2 * config.interval : config.interval)) return;
  recent_.cut();
  if (start_ && tryStart()) return;
  if (now_.state == LocalizationState::localized || now_.state == LocalizationState::lost) track();
  if (now_.state == LocalizationState::localized) {
    if (recent_.travelled() - fixed_at_ <= config.lost_after) return;
    now_.state = LocalizationState::lost;
  }
  if (isDue(searched_at_, config.search_interval)) searchPlaces();
}

SubmapPtr Localizer::openSubmap() const {
  return std::make_shared<const Submap>(recent_.submap(config_.localization.open_length));
}

void Localizer::note(const MapMatch& match) {
  now_.attempted = true;
  now_.target = match.target;
  now_.overlap = match.overlap;
  now_.coherence = match.coherence;
  now_.reason = match.reason;
}

/// One registration is enough: somebody vouches for the place.
bool Localizer::tryStart() {
  const SubmapPtr open = openSubmap();
  MapMatch best;
  for (const double degrees : kTurns) {
    const MapMatch match = matcher_.relocate(open, *start_ * T_odom_base_ * turnedBy(degrees));
    if (degrees == 0.0 || isBetter(match, best)) best = match;
  }
  note(best);
  if (best.accepted) believe(best);
  return best.accepted;
}

/// Where the odometry has gone far without the map, its pose has to be confirmed like any other
/// place.
void Localizer::track() {
  const SubmapPtr open = openSubmap();
  const Pose T_map_base = now_.T_map_odom * T_odom_base_;
  if (now_.state == LocalizationState::lost) {
    tryPlace(open, T_map_base);
    return;
  }
  const MapMatch match =
      matcher_.track(open, T_map_base, recent_.travelled() - fixed_at_, covariance_.base());
  note(match);
  if (match.accepted) believe(match);
}

void Localizer::searchPlaces() {
  const SubmapPtr open = openSubmap();
  const LocalMap local = recent_.localMap(config_.localization.search_length);
  for (const Pose& T_map_base : places_.search(local)) {
    tryPlace(open, T_map_base);
    if (now_.state == LocalizationState::localized) return;
  }
}

void Localizer::tryPlace(const SubmapPtr& open, const Pose& T_map_base) {
  const MapMatch match = matcher_.relocate(open, T_map_base);
  note(match);
  if (!match.accepted) return;
  const Pose T_map_odom = match.T_map_open * T_odom_base_.inverse();
  if (agreesWithAny(T_map_odom)) return believe(match);
  hypotheses_.push_back({T_map_odom, recent_.travelled()});
  if (now_.state == LocalizationState::searching) now_.state = LocalizationState::candidate;
  if (now_.state == LocalizationState::candidate && !start_) {
    now_.T_map_odom = T_map_odom;
    covariance_ = PoseCovariance(guessCovariance());
  }
}

bool Localizer::agreesWithAny(const Pose& T_map_odom) const {
  return std::any_of(hypotheses_.begin(), hypotheses_.end(),
                     [&](const Hypothesis& hypothesis) { return agrees(hypothesis, T_map_odom); });
}

/// Whether the odometry carries the hypothesis there, as far as it can be trusted.
bool Localizer::agrees(const Hypothesis& hypothesis, const Pose& T_map_odom) const {
  const LocalizationConfig& config = config_.localization;
  const double apart = recent_.travelled() - hypothesis.travelled;
  // The next attempts come at least, however rare they are.
  const double farthest =
      std::max(config.search_length, 2.5 * std::max(config.interval, config.search_interval));
  if (apart < config.interval || apart > farthest) return false;
  const PairwiseConsistencyConfig& consistency = config_.loops.closer.consistency;
  const Pose difference =
      (hypothesis.T_map_odom * T_odom_base_).inverse() * (T_map_odom * T_odom_base_);
  return difference.translation.norm() <=
             consistency.translation + consistency.translation_drift * apart &&
         difference.angle() * 180.0 / M_PI <=
             consistency.rotation + consistency.rotation_drift * apart;
}

void Localizer::believe(const MapMatch& match) {
  if (now_.state != LocalizationState::localized) window_.clearFixes();
  window_.fix(match.T_map_open, match.information);
  const std::optional<Pose> solved = window_.solve();
  now_.T_map_odom = solved ? *solved : match.T_map_open * T_odom_base_.inverse();
  now_.state = LocalizationState::localized;
  InformationEstimate estimate;
  estimate.information = match.information;
  estimate.mean_squared_residual = match.mean_squared_residual;
  covariance_ = PoseCovariance(
      MotionCovariance(config_.information).of(estimate) +
      diagonal(config_.localization.deviation, config_.localization.rotation_deviation));
  fixed_at_ = recent_.travelled();
  start_.reset();
  hypotheses_.clear();
}

}  // namespace revisit_slam
