// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/map_to_extend.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "revisit_slam/io/folder_lock.h"

namespace revisit_slam {

KnownMapPtr readMapToExtend(const std::string& folder, const PlaceRecognitionConfig& recognition,
                            std::vector<std::string>& notices) {
  if (isLocked(folder))
    throw std::runtime_error("the session '" + folder +
                             "' is being written: a drive can go on from it when that has ended");
  std::vector<std::string> own;
  auto map = std::make_shared<const KnownMap>(readKnownMap(folder, {}, recognition, own));
  const bool is_recognisable =
      std::any_of(map->places.begin(), map->places.end(),
                  [](const PlaceView& place) { return place.features.size() > 0; });
  if (!is_recognisable)
    throw std::runtime_error("no place of the session '" + folder + "' can be recognised" +
                             (own.empty() ? "" : ": " + own.back()));
  notices.insert(notices.end(), own.begin(), own.end());
  return map;
}

}  // namespace revisit_slam
