// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_features.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <opencv2/features2d.hpp>
#include <tuple>

#include "revisit_slam/loops/recognition/place_matching.h"

namespace revisit_slam {
namespace {

struct OrbFeatures {
  std::vector<cv::KeyPoint> points;
  cv::Mat descriptors;
};

OrbFeatures detect(const DensityImage& image, const PlaceFeaturesConfig& config) {
  OrbFeatures found;
  if (std::min(image.width, image.height) <= 2 * config.patch_size) return found;
  const cv::Mat pixels(image.height, image.width, CV_8UC1,
                       const_cast<std::uint8_t*>(image.values.data()));
  constexpr float unused_scale = 1.2f;  // of the second octave
  const auto orb = cv::ORB::create(config.max_features, unused_scale, 1, config.patch_size, 0, 2,
                                   cv::ORB::HARRIS_SCORE, config.patch_size, config.fast_threshold);
  orb->detectAndCompute(pixels, cv::noArray(), found.points, found.descriptors);
  return found;
}

/// Indices from strong to weak; in a fixed order where they are equal.
std::vector<int> byStrength(const std::vector<cv::KeyPoint>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int index) {
    const cv::KeyPoint& p = points[static_cast<std::size_t>(index)];
    return std::make_tuple(-p.response, p.pt.y, p.pt.x);
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  return order;
}

/// All features of the image, ORB keeps more than asked for where strengths are equal.
PlaceFeatures compact(const OrbFeatures& orb, const Pixel& origin, int max_features) {
  PlaceFeatures features;
  for (const int index : byStrength(orb.points)) {
    if (features.size() == static_cast<std::size_t>(max_features)) break;
    const cv::KeyPoint& point = orb.points[static_cast<std::size_t>(index)];
    features.keypoints.push_back({static_cast<std::int16_t>(origin.x() + std::lround(point.pt.x)),
                                  static_cast<std::int16_t>(origin.y() + std::lround(point.pt.y)),
                                  point.angle * static_cast<float>(M_PI / 180.0)});
    std::memcpy(features.descriptors.emplace_back().data(), orb.descriptors.ptr(index),
                sizeof(Descriptor));
  }
  return features;
}

}  // namespace

PlaceFeatures extractPlaceFeatures(const DensityImage& image, const PlaceFeaturesConfig& config) {
  const PlaceFeatures all = compact(detect(image, config), image.origin, config.max_features);
  const std::vector<bool> repeated = repeatedDescriptors(all.descriptors, config.self_similarity);
  PlaceFeatures distinct;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (repeated[i]) continue;
    distinct.descriptors.push_back(all.descriptors[i]);
    distinct.keypoints.push_back(all.keypoints[i]);
  }
  distinct.descriptors.shrink_to_fit();
  distinct.keypoints.shrink_to_fit();
  return distinct;
}

}  // namespace revisit_slam
