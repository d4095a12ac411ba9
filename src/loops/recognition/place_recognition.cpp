// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_recognition.h"

#include <algorithm>
#include <numeric>

#include "revisit_slam/loops/recognition/ground_alignment.h"
#include "revisit_slam/loops/recognition/place_alignment.h"
#include "revisit_slam/loops/recognition/place_matching.h"
#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kMapsAtATime = 8;
constexpr std::size_t kFewestInliers = 3;  // two points fit any rotation and translation

std::vector<PointPair> pointPairs(const std::vector<Keypoint>& source,
                                  const std::vector<Keypoint>& target,
                                  const std::vector<FeatureMatch>& matches) {
  std::vector<PointPair> pairs;
  pairs.reserve(matches.size());
  for (const FeatureMatch& match : matches) {
    const Keypoint &s = source[match.source], &t = target[match.target];
    pairs.push_back({s.centre(), t.centre(), static_cast<double>(t.angle - s.angle)});
  }
  return pairs;
}

/// An alignment of the planes of two grids, as one of their level frames.
Pose lift(const Eigen::Isometry2d& T, double resolution) {
  const double angle = Eigen::Rotation2Dd(T.linear()).angle();
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())),
          {resolution * T.translation().x(), resolution * T.translation().y(), 0.0}};
}

bool isBetter(const PlaceMatch& a, const PlaceMatch& b) {
  return a.inliers != b.inliers ? a.inliers > b.inliers : a.target < b.target;
}

}  // namespace

PlaceView viewPlace(const LocalMap& map, const PlaceRecognitionConfig& config) {
  PlaceView view;
  view.id = map.id;
  view.T_level_local = levelOnGround(map.points);
  view.image = densityImage(map.points, view.T_level_local, config.image);
  view.features = extractPlaceFeatures(view.image, config.features);
  return view;
}

std::optional<PlaceMatch> PlaceRecognition::compare(const PlaceView& query,
                                                    const Place& place) const {
  const std::vector<FeatureMatch> matches =
      matchFeatures(query.features.descriptors, place.descriptors, config_.max_distance);
  if (matches.size() < kFewestInliers) return std::nullopt;
  const PlanarAlignmentConfig alignment{config_.inlier_radius, config_.max_turn, config_.separation,
                                        config_.samples, static_cast<std::uint32_t>(config_.seed)};
  const PlanarAlignment found =
      alignPlanar(pointPairs(query.features.keypoints, place.keypoints, matches), alignment);
  if (found.inliers < static_cast<int>(kFewestInliers)) return std::nullopt;
  const double resolution = config_.image.resolution;
  const Pose T_target_source =
      place.T_level_local.inverse() * lift(found.T_target_source, resolution) * query.T_level_local;
  return PlaceMatch{query.id,
                    place.id,
                    T_target_source,
                    found.inliers,
                    static_cast<int>(matches.size()),
                    resolution * found.rms};
}

std::optional<PlaceMatch> PlaceRecognition::recognise(const LocalMap& map) {
  last_ = viewPlace(map, config_);
  candidates_ = find(last_, placesToSearch(map));
  add(map.id, last_.T_level_local, last_.features);
  if (candidates_.empty() || !isRecognised(candidates_.front())) return {};
  return candidates_.front();
}

/// Where the odometry knows the way from the newest ones to the map, those say nothing new.
std::size_t PlaceRecognition::placesToSearch(const LocalMap& map) {
  if (map.after_loss) before_loss_ = places_.size();
  std::size_t places = places_.size();
  for (int i = 0; i < config_.newest_excluded && places > before_loss_; ++i, --places)
    if (places_[places - 1].id.session != map.id.session) break;
  return places;
}

void PlaceRecognition::add(LocalMapId id, const Pose& T_level_local,
                           const PlaceFeatures& features) {
  places_.push_back(
      {id, T_level_local, features.keypoints, DescriptorBlocks(features.descriptors)});
}

/// Among the first `places`.
std::vector<PlaceMatch> PlaceRecognition::find(const PlaceView& query, std::size_t places) const {
  std::vector<std::size_t> all(places);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return find(query, all);
}

std::vector<PlaceMatch> PlaceRecognition::find(const PlaceView& query,
                                               const std::vector<std::size_t>& among) const {
  std::vector<std::optional<PlaceMatch>> found(among.size());
  Chunks(found.size(), kMapsAtATime).forEach([&](std::size_t, Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      found[i] = compare(query, places_.at(among[i]));
  });
  std::vector<PlaceMatch> matches;
  for (const auto& match : found)
    if (match) matches.push_back(*match);
  std::sort(matches.begin(), matches.end(), isBetter);
  return matches;
}

std::size_t PlaceRecognition::bytes() const {
  std::size_t sum = 0;
  for (const Place& place : places_)
    sum += sizeof(Place) + place.keypoints.size() * sizeof(Keypoint) + place.descriptors.bytes();
  return sum;
}

}  // namespace revisit_slam
