// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <random>

#include "revisit_slam/loops/recognition/place_recognition.h"

namespace revisit_slam {

/// Features of places that have nothing to do with each other, and of the same places seen again.
class AlikePlaces {
 public:
  static constexpr std::size_t kFeatures = 150;
  static constexpr int kFlippedBits = 25;

  PlaceFeatures place(unsigned number) const {
    std::mt19937_64 random(number + 1);
    PlaceFeatures features;
    for (std::size_t i = 0; i < kFeatures; ++i) {
      features.descriptors.push_back({random(), random(), random(), random()});
      features.keypoints.push_back({static_cast<std::int16_t>(random() % 200),
                                    static_cast<std::int16_t>(random() % 200), 0.0f});
    }
    return features;
  }

  /// A share of the features is there again with some bits flipped, moved by (20, -7) pixels; the
  /// others are new.
  PlaceFeatures seenAgain(unsigned number, double share) const {
    PlaceFeatures features = place(number);
    const PlaceFeatures others = place(number + 100000);
    std::mt19937_64 random(number + 7);
    for (std::size_t i = 0; i < features.size(); ++i) {
      features.keypoints[i].i = static_cast<std::int16_t>(features.keypoints[i].i + 20);
      features.keypoints[i].j = static_cast<std::int16_t>(features.keypoints[i].j - 7);
      if (static_cast<double>(i) >= share * static_cast<double>(kFeatures))
        features.descriptors[i] = others.descriptors[i];
      for (int flip = 0; flip < kFlippedBits; ++flip)
        features.descriptors[i][random() % 4] ^= std::uint64_t{1} << (random() % 64);
    }
    return features;
  }

  static PlaceView view(LocalMapId id, PlaceFeatures features) {
    PlaceView view;
    view.id = id;
    view.features = std::move(features);
    return view;
  }
};

}  // namespace revisit_slam
