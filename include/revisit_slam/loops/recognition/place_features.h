// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/loops/recognition/density_image.h"
#include "revisit_slam/loops/recognition/place_descriptor.h"

namespace revisit_slam {

/// Where a feature lies in the grid of a level frame (ORB's corners in one octave lie on whole
/// pixels) and how it is turned: the direction from it to the centroid of its patch, radians from x
/// towards y.
struct Keypoint {
  std::int16_t i = 0;
  std::int16_t j = 0;
  float angle = 0.0f;

  Eigen::Vector2d centre() const { return {i + 0.5, j + 0.5}; }  ///< in pixels
};

/// What place recognition sees of a local map: 40 bytes a feature.
struct PlaceFeatures {
  std::vector<Descriptor> descriptors;
  std::vector<Keypoint> keypoints;

  std::size_t size() const { return descriptors.size(); }
};

/// ORB features that are unlike all others of their own image, strongest first. None for an image
/// that is too small or empty.
PlaceFeatures extractPlaceFeatures(const DensityImage& image, const PlaceFeaturesConfig& config);

}  // namespace revisit_slam
