// SPDX-License-Identifier: MIT
#include "revisit_slam/session/stored_submap.h"

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "revisit_slam/io/bytes.h"
#include "revisit_slam/io/record_file.h"
#include "submap_bounds.h"

namespace revisit_slam {
namespace {

constexpr char kKind[] = "RSSUBMAP";
/// 2: a fifth plane of the occupancy, which software of version 1 would take for a block.
constexpr std::uint32_t kVersion = 2;

std::string record(SubmapRecord type, const ByteWriter& payload) {
  return encodeRecord({static_cast<std::uint32_t>(type), payload.bytes()});
}

ByteWriter head(const Submap& submap) {
  ByteWriter bytes;
  bytes.put(submap.id);
  bytes.put(submap.local_map);
  bytes.put(submap.first_scan);
  bytes.put(submap.travelled_begin);
  bytes.put(submap.travelled_end);
  bytes.put(submap.T_odom_submap);
  bytes.put(submap.scale);
  bytes.put(submap.unsure_begin.weak);
  bytes.put(submap.unsure_begin.doubt);
  bytes.put(submap.unsure_begin.weak_height);
  return bytes;
}

ByteWriter trajectory(const Submap& submap) {
  ByteWriter bytes;
  for (std::size_t i = 0; i < submap.stamps.size(); ++i) {
    bytes.put(submap.stamps[i]);
    bytes.put(submap.T_submap_scan[i]);
  }
  return bytes;
}

template <typename Element>
ByteWriter listOf(const std::vector<Element>& elements) {
  ByteWriter bytes;
  bytes.putAll(elements);
  return bytes;
}

ByteWriter occupancyOf(const SubmapOccupancy& occupancy) {
  ByteWriter bytes;
  bytes.put(occupancy.resolution());
  for (const SubmapOccupancy::Entry& entry : occupancy.entries()) {
    for (int axis = 0; axis < 3; ++axis) bytes.put(static_cast<std::int32_t>(entry.block[axis]));
    bytes.put(static_cast<std::uint32_t>(entry.planes));
    const BlockCounts counts = occupancy.counts(entry);
    for (int plane = 0; plane < BlockCounts::kPlanes; ++plane)
      if (entry.planes >> plane & 1)
        for (const std::uint64_t word : counts.planes[plane].words) bytes.put(word);
  }
  return bytes;
}

ByteWriter sightingsOf(const Sightings& sightings) {
  ByteWriter bytes;
  bytes.put(static_cast<std::uint32_t>(sightings.groups.size()));
  for (const PointsSeen& group : sightings.groups) {
    bytes.put(group.scan);
    for (int axis = 0; axis < 3; ++axis) bytes.put(group.sensor_base[axis]);
    bytes.put(group.end);
  }
  bytes.putAll(sightings.lasted);
  return bytes;
}

void readHead(ByteReader bytes, Submap& submap) {
  submap.id = bytes.id<SubmapId>();
  submap.local_map = bytes.id<LocalMapId>();
  submap.first_scan = bytes.id<ScanId>();
  submap.travelled_begin = bytes.get<double>();
  submap.travelled_end = bytes.get<double>();
  submap.T_odom_submap = bytes.pose();
  if (!std::isfinite(submap.travelled_begin) || !std::isfinite(submap.travelled_end))
    throw std::runtime_error("a submap has no length");
  if (bytes.left() == 0) return;  // written before these were
  submap.scale = bytes.get<double>();
  if (!(submap.scale > 1e-3 && submap.scale <= 1.0))  // MapScale makes maps no coarser
    throw std::runtime_error("a submap has no scale");
  submap.unsure_begin.weak = bytes.get<double>();
  submap.unsure_begin.doubt = bytes.get<double>();
  // Where it was not told from the plane, both are as weak.
  const bool is_known = bytes.left() > 0;
  submap.unsure_begin.weak_height = is_known ? bytes.get<double>() : submap.unsure_begin.weak;
}

void readTrajectory(ByteReader bytes, Submap& submap) {
  while (bytes.left() > 0) {
    submap.stamps.push_back(bytes.stamp());
    submap.T_submap_scan.push_back(bytes.pose());
    if (!isInBounds(submap.T_submap_scan.back().translation.cast<float>()))
      throw std::runtime_error("a scan is far from its submap");
  }
}

constexpr double kFinest = 1e-3;  // m, of the edges of voxels
constexpr int kFarthestBlock = 1'000'000;

Points readPoints(ByteReader bytes) {
  Points points = bytes.rest<Eigen::Vector3f>();
  for (const Eigen::Vector3f& point : points)
    if (!isInBounds(point)) throw std::runtime_error("a point is none");
  return points;
}

Points readNormals(ByteReader bytes) {
  constexpr float longest = 1.001f;  // squared; that of a point without a plane is zero
  Points normals = bytes.rest<Eigen::Vector3f>();
  for (const Eigen::Vector3f& normal : normals)
    if (!(normal.squaredNorm() < longest)) throw std::runtime_error("a normal is none");
  return normals;
}

std::vector<float> readIntensities(ByteReader bytes) {
  std::vector<float> intensities = bytes.rest<float>();
  for (const float intensity : intensities)
    if (!std::isfinite(intensity)) throw std::runtime_error("an intensity is none");
  return intensities;
}

SubmapOccupancyPtr readOccupancy(ByteReader bytes) {
  const auto resolution = bytes.get<double>();
  if (!(resolution > kFinest)) throw std::runtime_error("voxels have no edge");
  auto occupancy = std::make_shared<SubmapOccupancy>(resolution);
  std::optional<Voxel> last;
  while (bytes.left() > 0) {
    Voxel block;
    for (int axis = 0; axis < 3; ++axis) block[axis] = bytes.get<std::int32_t>();
    const bool is_near = block.minCoeff() > -kFarthestBlock && block.maxCoeff() < kFarthestBlock;
    if (!is_near || (last && !BlockOrder()(*last, block)))
      throw std::runtime_error("blocks of the occupancy are in no order");
    last = block;
    const auto planes = bytes.get<std::uint32_t>();
    BlockCounts counts;
    for (int plane = 0; plane < BlockCounts::kPlanes; ++plane)
      if (planes >> plane & 1)
        for (std::uint64_t& word : counts.planes[plane].words) word = bytes.get<std::uint64_t>();
    occupancy->append(block, counts);
  }
  occupancy->shrinkToFit();
  return occupancy;
}

Sightings readSightings(ByteReader bytes) {
  Sightings sightings;
  const auto groups = bytes.get<std::uint32_t>();
  std::uint32_t last = 0;
  for (std::uint32_t i = 0; i < groups; ++i) {
    PointsSeen group;
    group.scan = bytes.get<std::uint32_t>();
    for (int axis = 0; axis < 3; ++axis) group.sensor_base[axis] = bytes.get<float>();
    group.end = bytes.get<std::uint32_t>();
    if (group.end < last || !isInBounds(group.sensor_base))
      throw std::runtime_error("sightings are none");
    last = group.end;
    sightings.groups.push_back(group);
  }
  sightings.lasted = bytes.rest<std::uint16_t>();
  if (sightings.lasted.size() != last) throw std::runtime_error("sightings are of other points");
  return sightings;
}

void take(const Record& record, Submap& submap, MapUpdate& update) {
  const ByteReader bytes(record.payload);
  switch (static_cast<SubmapRecord>(record.type)) {
    case SubmapRecord::submap:
      return readHead(bytes, submap);
    case SubmapRecord::trajectory:
      return readTrajectory(bytes, submap);
    case SubmapRecord::points:
      submap.points = readPoints(bytes);
      return;
    case SubmapRecord::normals:
      submap.normals = readNormals(bytes);
      return;
    case SubmapRecord::detail:
      update.detail_submap = readPoints(bytes);
      return;
    case SubmapRecord::occupancy:
      update.occupancy = readOccupancy(bytes);
      return;
    case SubmapRecord::sightings:
      update.sightings = readSightings(bytes);
      return;
    case SubmapRecord::intensities:
      update.intensities = readIntensities(bytes);
      return;
  }
}

}  // namespace

std::string encodeSubmap(const MapUpdate& update) {
  const Submap& submap = *update.submap;
  std::string file = recordFileHeader(kKind, kVersion);
  file += record(SubmapRecord::submap, head(submap));
  file += record(SubmapRecord::trajectory, trajectory(submap));
  file += record(SubmapRecord::points, listOf(submap.points));
  file += record(SubmapRecord::normals, listOf(submap.normals));
  file += record(SubmapRecord::detail, listOf(update.detail_submap));
  if (update.occupancy) file += record(SubmapRecord::occupancy, occupancyOf(*update.occupancy));
  if (!update.sightings.empty())
    file += record(SubmapRecord::sightings, sightingsOf(update.sightings));
  if (!update.intensities.empty())
    file += record(SubmapRecord::intensities, listOf(update.intensities));
  return file;
}

MapUpdate readSubmap(const std::string& path, const std::set<SubmapRecord>& wanted) {
  std::set<std::uint32_t> types{static_cast<std::uint32_t>(SubmapRecord::submap)};
  for (const SubmapRecord type : wanted) types.insert(static_cast<std::uint32_t>(type));
  const RecordFile file = readRecordFile(path, kKind, kVersion, types);
  if (!file.damage.empty()) throw std::runtime_error(file.damage);
  auto submap = std::make_shared<Submap>();
  MapUpdate update;
  try {
    for (const Record& record : file.records) take(record, *submap, update);
    const bool are_of_the_points = wanted.count(SubmapRecord::points) == 0 ||
                                   wanted.count(SubmapRecord::normals) == 0 ||
                                   submap->normals.size() == submap->points.size();
    if (!are_of_the_points) throw std::runtime_error("normals are of other points");
    const bool are_of_the_detail = update.intensities.empty() ||
                                   wanted.count(SubmapRecord::detail) == 0 ||
                                   update.intensities.size() == update.detail_submap.size();
    if (!are_of_the_detail) throw std::runtime_error("intensities are of other points");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("'" + path + "' cannot be used: " + error.what());
  }
  update.submap = std::move(submap);
  return update;
}

}  // namespace revisit_slam
