// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/odometry.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "revisit_slam/odometry/deskew_correction.h"
#include "revisit_slam/odometry/recovery_guesses.h"
#include "revisit_slam/odometry/seen_through.h"
#include "revisit_slam/priors/motion_reading.h"

namespace revisit_slam {
namespace {

/// Down-sampling of the published system, in voxels of the map: fine for the map, coarse for ICP.
constexpr double kMapPointSpacing = 0.5;
constexpr double kSourcePointSpacing = 1.5;
/// How often the voxels follow the surroundings; a look over the local map takes about 1 ms.
constexpr std::uint32_t kScansPerScale = 10;

/// A drive that fits nowhere for longer is not worth the time of further guesses.
constexpr int kMostVainRecoveries = 3;
/// So many are enough to tell a right guess; a wrong one may wander for hundreds.
constexpr int kGuessIterations = 20;

RegistrationConfig forGuesses(RegistrationConfig config) {
  config.max_iterations = std::min(config.max_iterations, kGuessIterations);
  return config;
}

/// How the points for the map are taken from a scan, and from these those for ICP.
struct Sampling {
  using Filter = const VoxelFilter::Indices& (VoxelFilter::*)(const Points&, double, Points&);
  Filter of_map, of_source;
};

Sampling samplingOf(const OdometryConfig& config) {
  if (config.sampling == "hash") return {&VoxelFilter::filterHashed, &VoxelFilter::filterHashed};
  return {&VoxelFilter::filter, &VoxelFilter::filterSpread};
}

void select(const std::vector<float>& values, const VoxelFilter::Indices& indices,
            std::vector<float>& selected) {
  selected.clear();
  if (values.empty()) return;
  for (const std::uint32_t index : indices) selected.push_back(values[index]);
}

/// m, the median distance from the sensor.
double medianRange(const Points& points_base, const Eigen::Vector3d& sensor_base) {
  std::vector<float> ranges;
  for (const Eigen::Vector3f& point : points_base)
    ranges.push_back((point - sensor_base.cast<float>()).norm());
  const auto middle = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() / 2);
  std::nth_element(ranges.begin(), middle, ranges.end());
  return *middle;
}

/// What any platform may do between two scans however steadily it moved or rested before: braking,
/// being picked up.
constexpr double kSuddenAcceleration = 5.0;         // m/s^2
constexpr double kSuddenAngularAcceleration = 1.0;  // rad/s^2

/// See RegisteredScan::jump. After a gap the motion may have become any other.
double jumpOf(const PredictedMotion& predicted, const Tangent& deviation,
              const Matrix6& information) {
  if (!predicted.covariance || predicted.is_after_gap || information.isZero()) return 0.0;
  Matrix6 covariance =
      *predicted.covariance + (information + Matrix6::Identity() / kUnmeasured).inverse();
  const double squared = predicted.seconds * predicted.seconds;
  covariance.diagonal().head<3>().array() += std::pow(kSuddenAcceleration * squared, 2);
  covariance.diagonal().tail<3>().array() += std::pow(kSuddenAngularAcceleration * squared, 2);
  double largest = 0.0;
  for (const Eigen::Index first : {0, 3}) {
    const Eigen::Vector3d d = deviation.segment<3>(first);
    const Eigen::Matrix3d S = covariance.block<3, 3>(first, first);
    largest = std::max(largest, d.dot(S.ldlt().solve(d)));
  }
  return std::sqrt(largest);
}

/// Of what is in one place alone, and not less of all: where little of the former is in view a
/// wrong place may explain more of it.
bool explainsMore(const RegistrationResult& a, const RegistrationResult& b) {
  return a.explained > b.explained && a.explained_anywhere >= b.explained_anywhere;
}

/// Points that several sensors saw are on no common rings.
RingSpacing ringsOf(const Scan& scan) {
  return scan.views.empty() ? RingSpacing(scan.points, scan.T_base_sensor) : RingSpacing();
}

}  // namespace

const char* toString(OdometryOutcome outcome) {
  switch (outcome) {
    case OdometryOutcome::registered:
      return "registered";
    case OdometryOutcome::duplicate_stamp:
      return "duplicate stamp";
    case OdometryOutcome::time_went_back:
      return "time went back";
    case OdometryOutcome::no_point_in_range:
      return "no point in range";
  }
  return "unknown";
}

Odometry::Odometry(const OdometryConfig& config)
    : Odometry(config, std::make_unique<ConstantVelocityPredictor>(config)) {}

Odometry::Odometry(const OdometryConfig& config, std::unique_ptr<MotionPredictor> predictor)
    : config_(config),
      predictor_(std::move(predictor)),
      scale_(config.map.voxel_size, config.adaptive_voxel_size),
      map_(config.map, config.registration.planes),
      registration_(config.registration),
      guesses_(forGuesses(config.registration)),
      threshold_(config.threshold, config.max_range),
      fit_(config.fit) {
  config.bodyBox();  // throws where it is none
}

OdometryResult Odometry::align(const Scan& scan) {
  OdometryResult result;
  aligned_.reset();
  if (scans_ > 0 && scan.stamp <= previous_stamp_) {
    result.outcome = scan.stamp == previous_stamp_ ? OdometryOutcome::duplicate_stamp
                                                   : OdometryOutcome::time_went_back;
    return result;
  }
  StageClock clock;
  const PredictedMotion predicted = predictor_->predict(scan.stamp);
  PreprocessedScan preprocessed =
      preprocess(scan, predicted.velocity, config_, predicted.is_known ? predicted.seconds : 0.0,
                 predicted.sweep ? &*predicted.sweep : nullptr);
  result.too_near = preprocessed.too_near;
  result.too_far = preprocessed.too_far;
  result.on_body = preprocessed.on_body;
  if (preprocessed.points_base.empty()) {
    result.outcome = OdometryOutcome::no_point_in_range;
    return result;
  }
  RegisteredScan& registered = result.scan.emplace();
  registered.id = {scans_};
  registered.stamp = scan.stamp;
  registered.deskewed = preprocessed.deskewed;
  registered.sensor_base = scan.T_base_sensor.translation;
  registered.views = std::move(preprocessed.views);
  registered.points_base = std::move(preprocessed.points_base);
  registered.intensities = std::move(preprocessed.intensities);
  sweep_fractions_ = std::move(preprocessed.sweep_fractions);
  clock.stage("preprocess");

  if (scans_ == 0) {
    chooseScale(registered);
  } else {
    downsample(registered);
  }
  registered.voxel_size = map_.voxelSize();
  clock.stage("downsample");

  const Pose T_odom_predicted = T_odom_previous_ * predicted.T_previous_base;
  if (predicted.covariance) registered.prior_information = predicted.covariance->inverse();
  registered.sigma = sigmaFor(predicted);
  const RingSpacing rings = ringsOf(scan);
  PosePrediction prediction = predictionOf(T_odom_predicted);
  if (predicted.is_measured) prediction.information = predicted.information;
  registered.registration = registration_.align(registered.source_base, source_sweep_fractions_,
                                                map_, prediction, registered.sigma, rings);
  recover(predicted, rings, registered);
  const Tangent jumped = log(T_odom_predicted.inverse() * registered.registration.T_odom_base);
  registered.jump = jumpOf(predicted, jumped, registered.registration.information);
  registered.verdict = verdictOn(registered);
  if (fit_.hasJumped(registered.jump))  // prediction or pose is as wrong as they differ
    registered.prior_information = (*predicted.covariance + jumped * jumped.transpose()).inverse();
  if (isContradicted(registered)) registered.verdict = PoseVerdict::lost;
  if (registered.verdict == PoseVerdict::lost) loseTrack(predicted, registered);
  registered.T_odom_base = registered.registration.T_odom_base;
  const bool begins_map = scans_ == 0 || registered.verdict == PoseVerdict::lost;
  if (scans_of_map_ == 1 && !begins_map && !predicted.is_after_gap)
    startAgain(scan, predicted.seconds, registered);
  first_scan_.reset();
  if (begins_map && registered.deskewed && config_.redo_first_scans) first_scan_ = scan;
  const Pose deviation = T_odom_predicted.inverse() * registered.T_odom_base;
  registered.deskew_error = log(deviation) - registered.registration.deskew_correction;
  if (!sweep_fractions_.empty()) deskewAgain(registered);
  registered.seconds_since_previous = predicted.seconds;
  if (predicted.seconds > 0.0)
    registered.velocity_base =
        log(T_odom_previous_.inverse() * registered.T_odom_base) / predicted.seconds;
  aligned_ = {scan.stamp,
              registered.T_odom_base,
              deviation,
              registered.registration.information,
              !predicted.is_after_gap && !predicted.is_measured,
              fitOf(registered.registration),
              registered.registration.sees_motion,
              registered.verdict,
              medianRange(registered.source_base, registered.sensor_base),
              std::nullopt};
  if (registered.views.empty())
    aligned_->seen = SeenPoints{registered.source_base, registered.sensor_base};
  clock.stage("register");
  result.times = clock.times();
  return result;
}

void Odometry::commit() {
  Aligned aligned = std::move(aligned_.value());
  aligned_.reset();
  if (aligned.verdict == PoseVerdict::lost) {
    map_ = emptyMap(scale_.voxelSize());
    threshold_ = AdaptiveThreshold(config_.threshold, config_.max_range);
    fit_ = FitJudge(config_.fit);
    predictor_->forget();
    scans_of_map_ = 0;
  } else if (aligned.enters_threshold) {
    threshold_.update(aligned.deviation);
  }
  motion_is_seen_ =
      aligned.verdict != PoseVerdict::lost && (motion_is_seen_ || aligned.sees_motion);
  map_.insert(map_points_base_, aligned.T_odom_base);
  map_.dropBeyond(aligned.T_odom_base.translation, config_.max_range);
  followScale(aligned);
  predictor_->observe(aligned.stamp, aligned.T_odom_base, aligned.information);
  T_odom_previous_ = aligned.T_odom_base;
  previous_seen_ = std::move(aligned.seen);
  previous_stamp_ = aligned.stamp;
  fit_.observe(aligned.fit, aligned.verdict);
  ++scans_;
  ++scans_of_map_;
}

OdometryResult Odometry::registerScan(const Scan& scan) {
  OdometryResult result = align(scan);
  if (result.scan) commit();
  return result;
}

LocalVoxelMap Odometry::emptyMap(double voxel_size) const {
  LocalVoxelMapConfig config = config_.map;
  config.voxel_size = voxel_size;
  return LocalVoxelMap(config, config_.registration.planes);
}

/// From the first scan of a drive, which alone may change the voxels by more than one step.
void Odometry::chooseScale(RegisteredScan& registered) {
  scale_ = VoxelScale(config_.map.voxel_size, config_.adaptive_voxel_size);
  LocalVoxelMap map_of_scan = map_;
  do {
    map_ = map_of_scan = emptyMap(scale_.voxelSize());
    downsample(registered);
    scale_.observe(medianRange(registered.source_base, registered.sensor_base));
    map_of_scan.insert(map_points_base_, Pose::identity());
  } while (scale_.shrink(map_of_scan));
}

/// The points of the local map stay; those that are too near to others for larger voxels go.
void Odometry::followScale(const Aligned& aligned) {
  scale_.observe(aligned.reach);
  if (scans_ % kScansPerScale != 0 || !scale_.follow(map_)) return;
  const Points points_base = map_.points(aligned.T_odom_base.inverse());
  map_ = emptyMap(scale_.voxelSize());
  map_.insert(points_base, aligned.T_odom_base);
}

PosePrediction Odometry::predictionOf(const Pose& T_odom_predicted) const {
  PosePrediction prediction(T_odom_predicted);
  prediction.motion_is_seen = motion_is_seen_;
  return prediction;
}

/// Where the motion was measured, its error is that of the measurement.
double Odometry::sigmaFor(const PredictedMotion& predicted) const {
  if (predicted.is_after_gap) return std::max(config_.threshold.initial, threshold_.sigma());
  if (!predicted.is_measured) return threshold_.sigma();
  const auto deviation = [&](Eigen::Index first) {
    return std::sqrt(predicted.covariance->diagonal().segment<3>(first).sum());
  };
  const double error =
      deviation(0) + 2.0 * config_.max_range * std::sin(0.5 * std::min(deviation(3), M_PI));
  return std::clamp(error, std::min(config_.registration.final_sigma, threshold_.sigma()),
                    threshold_.sigma());
}

void Odometry::downsample(RegisteredScan& registered) {
  const double voxel_size = map_.voxelSize();
  const Sampling sampling = samplingOf(config_);
  select(sweep_fractions_,
         (voxel_filter_.*sampling.of_map)(registered.points_base, kMapPointSpacing * voxel_size,
                                          map_points_base_),
         map_sweep_fractions_);
  select(map_sweep_fractions_,
         (voxel_filter_.*sampling.of_source)(map_points_base_, kSourcePointSpacing * voxel_size,
                                             registered.source_base),
         source_sweep_fractions_);
}

/// Keeps the guess from which the map explains most. After a gap a good fit may be that of the
/// ground alone. Of the first scans of a map most is explained where they do not move: by the rings
/// that the sensor draws on the ground. Where the map is given up otherwise, the others are tried
/// in any case.
void Odometry::recover(const PredictedMotion& predicted, const RingSpacing& rings,
                       RegisteredScan& registered) {
  if (config_.fit.good == 0.0 || !fit_.isSettled()) return;
  const auto fits = [&] { return fit_.isUsual(registered.registration.explained_anywhere); };
  if (fits() && !predicted.is_after_gap) vain_recoveries_ = 0;
  if (fits() && !predicted.is_after_gap) return;
  const bool is_vain = vain_recoveries_ >= kMostVainRecoveries;
  if (is_vain && verdictOn(registered) != PoseVerdict::lost) return;
  RegistrationResult best = registered.registration;
  for (const Pose& T_previous_base : recoveryGuesses(predicted)) {
    const RegistrationResult other =
        guesses_.align(registered.source_base, {}, map_, T_odom_previous_ * T_previous_base,
                       config_.threshold.initial, rings);
    if (explainsMore(other, best)) best = other;
  }
  if (explainsMore(best, registered.registration))
    registered.registration =
        registration_.align(registered.source_base, {}, map_, predictionOf(best.T_odom_base),
                            threshold_.sigma(), rings);
  vain_recoveries_ = fits() ? 0 : vain_recoveries_ + 1;
}

/// Only poor scans are looked at: the fit alone tells less, and where traffic has left planes in
/// the map right scans look through many.
bool Odometry::isContradicted(const RegisteredScan& registered) const {
  if (registered.verdict != PoseVerdict::poor || !previous_seen_ || !registered.views.empty())
    return false;
  const auto through = [&](const Points& source_base, const Eigen::Vector3d& sensor_base,
                           const Pose& T_odom_base) {
    return shareSeenThrough(source_base, sensor_base, T_odom_base, map_);
  };
  const SeenPoints& before = *previous_seen_;
  return fit_.isContradicted(
      through(registered.source_base, registered.sensor_base, registered.registration.T_odom_base),
      through(before.source_base, before.sensor_base, T_odom_previous_));
}

/// The pose is the prediction. Within the reach of the sensor it would have been found.
void Odometry::loseTrack(const PredictedMotion& predicted, RegisteredScan& registered) const {
  Matrix6 covariance = predicted.covariance.value_or(Matrix6::Zero());
  covariance.diagonal().head<3>().array() += config_.max_range * config_.max_range;
  covariance.diagonal().tail<3>().array() += M_PI * M_PI;
  registered.prior_information = covariance.inverse();
  registered.registration.T_odom_base = T_odom_previous_ * predicted.T_previous_base;
  registered.registration.deskew_correction = Tangent::Zero();
  registered.registration.information = Matrix6::Zero();
  registered.registration.outcome = RegistrationOutcome::no_fit;
}

/// Nothing was known of the motion when the first two scans of the map were deskewed. From both as
/// they are it comes out well enough to deskew them, and to register the second to the first, once
/// more.
void Odometry::startAgain(const Scan& scan, double seconds, RegisteredScan& registered) {
  const std::optional<Scan> first = std::exchange(first_scan_, std::nullopt);
  const bool matched =
      registered.registration.outcome != RegistrationOutcome::too_few_correspondences;
  if (!first || !registered.deskewed || !matched) return;
  const ConstantMotion motion(log(T_odom_previous_.inverse() * registered.T_odom_base) / seconds);
  RegisteredScan first_again;
  first_again.points_base = preprocess(*first, motion, config_).points_base;
  downsample(first_again);
  map_ = emptyMap(map_.voxelSize());
  map_.insert(map_points_base_, T_odom_previous_);
  PreprocessedScan preprocessed = preprocess(scan, motion, config_);
  registered.points_base = std::move(preprocessed.points_base);
  registered.intensities = std::move(preprocessed.intensities);
  downsample(registered);
  registered.registration =
      registration_.align(registered.source_base, {}, map_, predictionOf(registered.T_odom_base),
                          registered.sigma, ringsOf(scan));
  registered.T_odom_base = registered.registration.T_odom_base;
}

/// With what the registration found that the prediction had missed.
void Odometry::deskewAgain(RegisteredScan& registered) {
  const Tangent& correction = registered.registration.deskew_correction;
  applyDeskewCorrection(registered.points_base, sweep_fractions_, correction);
  applyDeskewCorrection(map_points_base_, map_sweep_fractions_, correction);
  applyDeskewCorrection(registered.source_base, source_sweep_fractions_, correction);
}

void Odometry::reconfigure(const OdometryConfig& config) {
  config_.max_range = config.max_range;
  threshold_.setMaxRange(config.max_range);
  config_.min_range = config.min_range;
  config_.deskew = config.deskew;
  predictor_->reconfigure(config);
}

}  // namespace revisit_slam
