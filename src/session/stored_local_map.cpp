// SPDX-License-Identifier: MIT
#include "revisit_slam/session/stored_local_map.h"

#include <cmath>
#include <stdexcept>

#include "revisit_slam/io/bytes.h"

namespace revisit_slam {
namespace {

constexpr char kKind[] = "RSLOCMAP";
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kMap = 1, kPlace = 2;

}  // namespace

StoredLocalMap storedLocalMap(const LocalMap& map, const PlaceView* view) {
  StoredLocalMap stored;
  stored.id = map.id;
  for (const SubmapPtr& submap : map.submaps) stored.submaps.push_back(submap->id);
  if (view == nullptr) return stored;
  stored.T_level_local = view->T_level_local;
  stored.pixel = view->image.resolution;
  stored.features = view->features;
  return stored;
}

std::vector<Record> recordsOf(const StoredLocalMap& map) {
  ByteWriter head, place;
  head.put(map.id);
  for (const SubmapId id : map.submaps) head.put(id);
  place.put(map.T_level_local);
  place.put(map.pixel);
  for (std::size_t i = 0; i < map.features.size(); ++i) {
    const Keypoint& keypoint = map.features.keypoints[i];
    place.put(keypoint.i);
    place.put(keypoint.j);
    place.put(keypoint.angle);
    for (const std::uint64_t word : map.features.descriptors[i]) place.put(word);
  }
  return {{kMap, head.bytes()}, {kPlace, place.bytes()}};
}

std::string encodeLocalMap(const StoredLocalMap& map) {
  std::string bytes = recordFileHeader(kKind, kVersion);
  for (const Record& record : recordsOf(map)) bytes += encodeRecord(record);
  return bytes;
}

std::vector<StoredLocalMap> localMapsOf(const std::vector<Record>& records) {
  std::vector<StoredLocalMap> maps;
  for (const Record& record : records) {
    ByteReader bytes(record.payload);
    if (record.type == kMap) {
      StoredLocalMap& map = maps.emplace_back();
      map.id = bytes.id<LocalMapId>();
      while (bytes.left() > 0) map.submaps.push_back(bytes.id<SubmapId>());
    } else if (record.type == kPlace && !maps.empty()) {
      StoredLocalMap& map = maps.back();
      map.T_level_local = bytes.pose();
      map.pixel = bytes.get<double>();
      while (bytes.left() > 0) {
        const auto i = bytes.get<std::int16_t>(), j = bytes.get<std::int16_t>();
        map.features.keypoints.push_back({i, j, bytes.get<float>()});
        if (!std::isfinite(map.features.keypoints.back().angle))
          throw std::runtime_error("a feature has no direction");
        for (std::uint64_t& word : map.features.descriptors.emplace_back())
          word = bytes.get<std::uint64_t>();
      }
    }
  }
  return maps;
}

StoredLocalMap readLocalMap(const std::string& path) {
  const RecordFile file = readRecordFile(path, kKind, kVersion);
  if (!file.damage.empty()) throw std::runtime_error(file.damage);
  const std::vector<StoredLocalMap> maps = localMapsOf(file.records);
  return maps.empty() ? StoredLocalMap{} : maps.front();
}

}  // namespace revisit_slam
