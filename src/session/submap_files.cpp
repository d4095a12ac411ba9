// SPDX-License-Identifier: MIT
#include "revisit_slam/session/submap_files.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "revisit_slam/io/pcd.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/mapping/point_map.h"

namespace revisit_slam {
namespace {

constexpr double kTile = 200.0;  // m

using Tile = std::pair<int, int>;

int tileOf(double metres) {
  return static_cast<int>(std::floor(metres / kTile));
}

/// The tiles that a box may touch once it is placed.
std::vector<Tile> tilesOf(const Eigen::AlignedBox3f& box, const Pose& T) {
  Eigen::AlignedBox2d placed;
  for (int corner = 0; corner < 8; ++corner)
    placed.extend(
        (T * Eigen::Vector3d(
                 box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner)).cast<double>()))
            .head<2>());
  std::vector<Tile> tiles;
  for (int x = tileOf(placed.min().x()); x <= tileOf(placed.max().x()); ++x)
    for (int y = tileOf(placed.min().y()); y <= tileOf(placed.max().y()); ++y)
      tiles.emplace_back(x, y);
  return tiles;
}

Points within(const Tile& tile, const Points& points, const Pose& T) {
  Points inside;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d placed = T * Eigen::Vector3d(point.cast<double>());
    if (Tile{tileOf(placed.x()), tileOf(placed.y())} == tile)
      inside.push_back(placed.cast<float>());
  }
  return inside;
}

}  // namespace

SubmapFiles::SubmapFiles(const std::string& folder) : folder_(folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw std::runtime_error("cannot make the folder '" + folder + "': " + error.message());
}

std::string SubmapFiles::file(std::size_t submap) const {
  char name[32];
  std::snprintf(name, sizeof(name), "/%06zu.pcd", submap);
  return folder_ + name;
}

void SubmapFiles::add(const SubmapPtr& submap, const Points& detail_submap) {
  const std::size_t id = submaps_.size();
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : detail_submap) box.extend(point);
  submaps_.push_back(submap);
  boxes_submap_.push_back(box);
  if (!detail_submap.empty()) writePcd(file(id), detail_submap);
}

Points SubmapFiles::read(std::size_t submap) const {
  return boxes_submap_.at(submap).isEmpty() ? Points() : readPcdPoints(file(submap));
}

void SubmapFiles::writeTable(const std::vector<Pose>& T_map_submap) const {
  std::ostringstream table;
  table << "submap,local_map,first_scan,last_scan,stamp,x,y,z,qx,qy,qz,qw\n";
  for (std::size_t i = 0; i < submaps_.size(); ++i) {
    const Submap& submap = *submaps_[i];
    const Eigen::Vector3d& t = T_map_submap.at(i).translation;
    const Eigen::Quaterniond& q = T_map_submap.at(i).rotation;
    char pose[256];
    std::snprintf(pose, sizeof(pose), "%.6f,%.6f,%.6f,%.9f,%.9f,%.9f,%.9f", t.x(), t.y(), t.z(),
                  q.x(), q.y(), q.z(), q.w());
    table << submap.id.value << "," << submap.local_map.value << "," << submap.first_scan.value
          << "," << submap.lastScan().value << "," << stampText(submap.stamps.front()) << ","
          << pose << "\n";
  }
  writeWholeText(folder_ + "/submaps.csv", table.str());
}

void SubmapFiles::merge(const std::string& path, const std::vector<Pose>& T_map_submap,
                        double voxel_size) const {
  std::map<Tile, std::vector<std::size_t>> submaps_of_tile;
  for (std::size_t i = 0; i < submaps_.size(); ++i)
    if (!boxes_submap_[i].isEmpty())
      for (const Tile& tile : tilesOf(boxes_submap_[i], T_map_submap.at(i)))
        submaps_of_tile[tile].push_back(i);
  if (submaps_of_tile.empty()) throw std::runtime_error("no points to write to '" + path + "'");
  writeWholeFile(path, [&](const std::string& temporary) {
    PcdStream stream(temporary);
    for (const auto& [tile, submaps] : submaps_of_tile) {
      PointMap merged(voxel_size);
      for (const std::size_t i : submaps)
        merged.insert(within(tile, read(i), T_map_submap[i]), Pose::identity());
      stream.write(merged.points());
    }
    stream.finish();
  });
}

}  // namespace revisit_slam
