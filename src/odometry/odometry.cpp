// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/odometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace revisit_slam {
namespace {

/// Down-sampling of the published system, in voxels of the map: fine for the map, coarse for ICP.
constexpr double kMapPointSpacing = 0.5;
constexpr double kSourcePointSpacing = 1.5;

void select(const std::vector<float>& values, const VoxelFilter::Indices& indices,
            std::vector<float>& selected) {
  selected.clear();
  if (values.empty()) return;
  for (const std::uint32_t index : indices) selected.push_back(values[index]);
}

}  // namespace

const char* toString(OdometryOutcome outcome) {
  switch (outcome) {
    case OdometryOutcome::registered: return "registered";
    case OdometryOutcome::duplicate_stamp: return "duplicate stamp";
    case OdometryOutcome::time_went_back: return "time went back";
    case OdometryOutcome::no_point_in_range: return "no point in range";
  }
  return "unknown";
}

Odometry::Odometry(const OdometryConfig& config, BeforeInsertion before_insertion)
    : config_(config),
      before_insertion_(std::move(before_insertion)),
      arena_(config.threads),
      map_(config.map, config.registration.planes),
      registration_(config.registration),
      threshold_(config.threshold, config.max_range) {}

OdometryResult Odometry::registerScan(const Scan& scan) {
  OdometryResult result;
  arena_.execute([&] { result = registerInArena(scan); });
  return result;
}

OdometryResult Odometry::registerInArena(const Scan& scan) {
  OdometryResult result;
  if (scans_ > 0 && scan.stamp <= previous_stamp_) {
    result.outcome = scan.stamp == previous_stamp_ ? OdometryOutcome::duplicate_stamp
                                                   : OdometryOutcome::time_went_back;
    return result;
  }
  const double seconds = secondsSincePrevious(scan.stamp);
  const bool long_gap = seconds > config_.max_prediction_time;
  const bool knows_motion = scans_ > 1 && !long_gap;
  StageClock clock;
  PreprocessedScan preprocessed =
      preprocess(scan, motion_, config_, knows_motion ? seconds : 0.0);
  result.too_near = preprocessed.too_near;
  result.too_far = preprocessed.too_far;
  if (preprocessed.points_base.empty()) {
    result.outcome = OdometryOutcome::no_point_in_range;
    return result;
  }
  RegisteredScan& registered = result.scan.emplace();
  registered.id = {scans_};
  registered.stamp = scan.stamp;
  registered.deskewed = preprocessed.deskewed;
  registered.sensor_base = scan.T_base_sensor.translation;
  registered.points_base = std::move(preprocessed.points_base);
  lags_ = std::move(preprocessed.lags);
  clock.stage("preprocess");

  downsample(registered);
  clock.stage("downsample");

  const Pose T_odom_predicted =
      T_odom_previous_ * motion_.after(std::min(seconds, config_.max_prediction_time));
  registered.sigma = long_gap ? std::max(config_.threshold.initial, threshold_.sigma())
                              : threshold_.sigma();
  registered.registration = registration_.align(registered.source_base, source_lags_, map_,
                                                T_odom_predicted, registered.sigma);
  registered.T_odom_base = registered.registration.T_odom_base;
  if (scans_ == 1 && !long_gap) startAgain(scan, seconds, registered);
  registered.deskew_error =
      log(T_odom_predicted.inverse() * registered.T_odom_base) - registered.registration.bend;
  if (!lags_.empty()) deskewAgain(registered);
  clock.stage("register");

  if (before_insertion_ && !map_.empty()) before_insertion_(registered, map_);
  clock.stage("gather");

  if (!long_gap) threshold_.update(T_odom_predicted.inverse() * registered.T_odom_base);
  map_.insert(map_points_base_, registered.T_odom_base);
  map_.dropBeyond(registered.T_odom_base.translation, config_.max_range);
  updateMotion(registered.T_odom_base, seconds);
  registered.velocity_base = motion_.velocity();
  previous_stamp_ = scan.stamp;
  if (scans_ == 0 && registered.deskewed) first_scan_ = scan;
  ++scans_;
  clock.stage("update_map");
  result.times = clock.times();
  return result;
}

void Odometry::downsample(RegisteredScan& registered) {
  const double voxel_size = config_.map.voxel_size;
  select(lags_,
         voxel_filter_.filter(registered.points_base, kMapPointSpacing * voxel_size,
                              map_points_base_),
         map_lags_);
  select(map_lags_,
         voxel_filter_.filterSpread(map_points_base_, kSourcePointSpacing * voxel_size,
                                    registered.source_base),
         source_lags_);
}

/// Nothing was known of the motion when the first two scans were deskewed. From both as they are it
/// comes out well enough to deskew them, and to register the second to the first, once more.
void Odometry::startAgain(const Scan& scan, double seconds, RegisteredScan& registered) {
  const std::optional<Scan> first = std::exchange(first_scan_, std::nullopt);
  const bool matched =
      registered.registration.outcome != RegistrationOutcome::too_few_correspondences;
  if (!first || !registered.deskewed || !matched) return;
  const ConstantMotion motion(log(registered.T_odom_base) / seconds);
  RegisteredScan first_again;
  first_again.points_base = preprocess(*first, motion, config_).points_base;
  downsample(first_again);
  map_ = LocalVoxelMap(config_.map, config_.registration.planes);
  map_.insert(map_points_base_, Pose::identity());
  registered.points_base = preprocess(scan, motion, config_).points_base;
  downsample(registered);
  registered.registration = registration_.align(registered.source_base, {}, map_,
                                                registered.T_odom_base, registered.sigma);
  registered.T_odom_base = registered.registration.T_odom_base;
}

/// With what the registration found that the prediction had missed.
void Odometry::deskewAgain(RegisteredScan& registered) {
  const Tangent& bend = registered.registration.bend;
  straighten(registered.points_base, lags_, bend);
  straighten(map_points_base_, map_lags_, bend);
  straighten(registered.source_base, source_lags_, bend);
}

double Odometry::secondsSincePrevious(Stamp stamp) const {
  return scans_ == 0 ? 0.0 : secondsBetween(previous_stamp_, stamp);
}

void Odometry::updateMotion(const Pose& T_odom_base, double seconds) {
  if (seconds > 0.0) motion_ = ConstantMotion(log(T_odom_previous_.inverse() * T_odom_base) / seconds);
  T_odom_previous_ = T_odom_base;
}

void Odometry::reconfigure(const OdometryConfig& config) {
  config_.max_range = config.max_range;
  threshold_.setMaxRange(config.max_range);
  config_.min_range = config.min_range;
  config_.deskew = config.deskew;
  config_.max_prediction_time = config.max_prediction_time;
}

}  // namespace revisit_slam
