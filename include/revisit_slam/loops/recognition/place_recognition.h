// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "revisit_slam/loops/recognition/place_features.h"
#include "revisit_slam/loops/recognition/place_nearest.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// Two local maps that seem to show the same place, and where the later lies in the earlier.
struct PlaceMatch {
  LocalMapId source;  ///< the query
  LocalMapId target;  ///< an earlier map
  Pose T_target_source;
  int inliers = 0;   ///< features, apart from each other, that agree on it
  int matches = 0;   ///< features that look alike
  double rms = 0.0;  ///< m, how well the inliers agree
};

/// A local map as place recognition sees it.
struct PlaceView {
  LocalMapId id;
  Pose T_level_local;
  DensityImage image;
  PlaceFeatures features;
};

PlaceView viewPlace(const LocalMap& map, const PlaceRecognitionConfig& config);

/// Recognises places from bird's-eye density images of local maps (Gupta et al., ICRA 2024; paper
/// Sec. III-C). The result does not depend on the number of threads of the TBB arena it runs in.
class PlaceRecognition {
 public:
  explicit PlaceRecognition(const PlaceRecognitionConfig& config) : config_(config) {}

  /// Takes effect with the next map; the places seen so far stay as they are.
  void reconfigure(const PlaceRecognitionConfig& config) { config_ = config; }

  /// Looks for `map` among the maps seen so far, but for the newest since its session began or the
  /// odometry had lost its track, and then adds it. Takes any map; one without features matches
  /// nothing.
  /// @return the best candidate, if more than min_inliers features agree on it.
  std::optional<PlaceMatch> recognise(const LocalMap& map);

  /// A place that another drive has seen.
  void add(LocalMapId id, const Pose& T_level_local, const PlaceFeatures& features);
  /// Of all places so far those on which at least three features of the query agree, best first.
  std::vector<PlaceMatch> find(const PlaceView& query) const { return find(query, places_.size()); }
  /// Of these alone, by the order in which they were added.
  std::vector<PlaceMatch> find(const PlaceView& query, const std::vector<std::size_t>& among) const;

  /// Whether enough features agree.
  bool isRecognised(const PlaceMatch& match) const { return match.inliers > config_.min_inliers; }

  /// Earlier maps on which at least three features of the last query agreed, best first.
  const std::vector<PlaceMatch>& candidates() const { return candidates_; }

  /// The last query with its picture.
  const PlaceView& lastView() const { return last_; }

  std::size_t size() const { return places_.size(); }
  /// What the maps seen so far take.
  std::size_t bytes() const;

 private:
  /// What is kept of a map: 40 bytes a feature.
  struct Place {
    LocalMapId id;
    Pose T_level_local;
    std::vector<Keypoint> keypoints;
    DescriptorBlocks descriptors;
  };

  std::vector<PlaceMatch> find(const PlaceView& query, std::size_t places) const;
  std::size_t placesToSearch(const LocalMap& map);
  std::optional<PlaceMatch> compare(const PlaceView& query, const Place& place) const;

  PlaceRecognitionConfig config_;
  std::vector<Place> places_;
  std::size_t before_loss_ = 0;  // places that the odometry does not connect with those that follow
  std::vector<PlaceMatch> candidates_;
  PlaceView last_;
};

}  // namespace revisit_slam
