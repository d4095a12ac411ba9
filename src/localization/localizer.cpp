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
  if (!has_scans_ || now_.scan.session != scan.id.session) {
    beginSession(informed);
  } else {
    covariance_.move(T_odom_base_.inverse() * scan.T_odom_base, informed.covariance_motion);
    if (informed.verdict == PoseVerdict::lost) beginTrack();
  }
  now_.scan = scan.id;
  T_odom_base_ = scan.T_odom_base;
  window_.add(nodeOf(informed));
  window_.shorten(config_.localization.window);
  if (++scans_ > kBentScans) recent_.insert(scan);
  if (recent_.open() > 0.5 * config_.localization.open_length) recent_.cut();
}

/// Of a place that may be as far off as a registration may move it.
Matrix6 Localizer::guessCovariance() const {
  return diagonal(config_.loops.closer.max_translation, config_.loops.closer.max_rotation);
}

/// What came before does not tell where the base is now. What was known of the pose is carried on,
/// with its covariance, until the map confirms or refutes it.
void Localizer::beginTrack() {
  recent_ = RecentMap(config_.submap_voxel_size, config_.localization.search_length, config_.scale);
  window_ = PoseWindow(config_.backend);
  hypotheses_.clear();
  fixed_at_ = -now_.since_fix;
  searched_at_ = started_at_ = 0.0;
  scans_ = 0;
  attempted_at_ = -config_.localization.interval;  // at once
  if (now_.state == LocalizationState::localized) now_.state = LocalizationState::lost;
  if (now_.state == LocalizationState::candidate && !start_)
    now_.state = LocalizationState::searching;
}

/// Another session has an odometry frame of its own; the base has gone on from where it was.
void Localizer::beginSession(const InformedScan& informed) {
  const bool is_first = !has_scans_;
  const bool was_known = has_scans_ && now_.state != LocalizationState::searching;
  const Pose T_map_base = now_.T_map_odom * T_odom_base_;
  beginTrack();
  has_scans_ = true;
  T_odom_base_ = informed.scan->T_odom_base;
  if (is_first && start_) now_.T_map_odom = *start_ * T_odom_base_.inverse();
  if (was_known) now_.T_map_odom = T_map_base * T_odom_base_.inverse();
  if (start_) start_ = now_.T_map_odom;
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
  if (isDue(attempted_at_, hurries ? 0.2 * config.interval : config.interval)) {
    recent_.cut();
    forgetOldGuesses();
    if (start_ && tryStart()) return;
    if (now_.state == LocalizationState::localized || now_.state == LocalizationState::lost)
      track();
  }
  if (now_.state == LocalizationState::localized) {
    if (recent_.travelled() - fixed_at_ <= config.lost_after) return;
    now_.state = LocalizationState::lost;
  }
  if (!isDue(searched_at_, config.search_interval)) return;
  recent_.cut();
  searchPlaces();
}

/// Travelled distance after which a place that came up is no longer looked for, m.
double Localizer::patience() const {
  // The next attempts come at least, however rare they are.
  const LocalizationConfig& config = config_.localization;
  return std::max(config.search_length,
                  2.5 * std::max({config.interval, config.search_interval, config.open_length}));
}

/// A place, given or recognised, that nothing has confirmed for so long is none.
void Localizer::forgetOldGuesses() {
  const double oldest = recent_.travelled() - patience();
  hypotheses_.erase(
      std::remove_if(hypotheses_.begin(), hypotheses_.end(),
                     [&](const Hypothesis& hypothesis) { return hypothesis.travelled < oldest; }),
      hypotheses_.end());
  if (start_ && started_at_ < oldest) start_.reset();
  if (now_.state == LocalizationState::candidate && !start_ && hypotheses_.empty())
    now_.state = LocalizationState::searching;
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
  if (now_.state == LocalizationState::lost) return tryPlaces(open, {T_map_base});
  const MapMatch match =
      matcher_.track(open, T_map_base, recent_.travelled() - fixed_at_, covariance_.base());
  note(match);
  if (match.accepted) believe(match);
}

void Localizer::searchPlaces() {
  const LocalMap local = recent_.localMap(config_.localization.search_length);
  tryPlaces(openSubmap(), places_.search(local));
}

/// A place that two registrations confirm is believed, unless they confirm another one as well.
void Localizer::tryPlaces(const SubmapPtr& open, const std::vector<Pose>& T_map_base) {
  std::vector<MapMatch> accepted, confirmed;
  for (const Pose& guess : T_map_base) {
    const MapMatch match = matcher_.relocate(open, guess);
    if (accepted.empty() || match.accepted) note(match);
    if (match.accepted) accepted.push_back(match);
    if (match.accepted && agreesWithAny(odomOf(match))) confirmed.push_back(match);
  }
  const auto is_elsewhere = [&](const MapMatch& match) {
    return !areNear(odomOf(match), odomOf(confirmed.front()), 0.0);
  };
  if (!confirmed.empty() && std::none_of(confirmed.begin(), confirmed.end(), is_elsewhere))
    return believe(confirmed.front());
  for (const MapMatch& match : accepted) guessAt(odomOf(match));
}

Pose Localizer::odomOf(const MapMatch& match) const {
  return match.T_map_open * T_odom_base_.inverse();
}

void Localizer::guessAt(const Pose& T_map_odom) {
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
  // What has been registered twice must not be the same surroundings.
  const double nearest = std::max(config.interval, config.open_length);
  return apart >= nearest && apart <= patience() &&
         areNear(hypothesis.T_map_odom, T_map_odom, apart);
}

/// Whether both place the base alike, after a way of `apart` m.
bool Localizer::areNear(const Pose& T_map_odom, const Pose& T_other_odom, double apart) const {
  const PairwiseConsistencyConfig& consistency = config_.loops.closer.consistency;
  const Pose difference = (T_map_odom * T_odom_base_).inverse() * (T_other_odom * T_odom_base_);
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
