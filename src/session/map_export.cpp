// SPDX-License-Identifier: MIT
#include "revisit_slam/session/map_export.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "revisit_slam/evaluation/consistency_builder.h"
#include "revisit_slam/evaluation/revisit_cells.h"
#include "revisit_slam/io/cloud_file.h"
#include "revisit_slam/io/grid_file.h"
#include "revisit_slam/io/octomap_file.h"
#include "revisit_slam/io/pcd.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/mapping/dynamic_point_filter.h"
#include "revisit_slam/mapping/point_map.h"
#include "revisit_slam/occupancy/dynamic_voxels.h"
#include "revisit_slam/session/composed_occupancy.h"
#include "revisit_slam/session/georeference_files.h"
#include "revisit_slam/session/seen_points.h"
#include "revisit_slam/session/stored_submap.h"
#include "revisit_slam/types/session_offsets.h"

namespace revisit_slam {
namespace {

constexpr double kTile = 200.0;                    // m, of the map in memory at a time
constexpr double kBesideTile = 1.0;                // m
constexpr float kSharesToWholeNumbers = 65535.0f;  // of intensities from 0 to 1
/// Larger than submaps are long, so that every passage through a cell has a keypose in it.
constexpr double kConsistencyCell = 40.0;  // m

const std::set<SubmapRecord> kCloudRecords{SubmapRecord::detail, SubmapRecord::intensities};

using Tile = std::pair<int, int>;

int tileOf(double metres, double edge) {
  return static_cast<int>(std::floor(metres / edge));
}

/// The tiles that a box may touch once it is placed.
std::vector<Tile> tilesOf(const Eigen::AlignedBox3f& box, const Pose& T, double edge) {
  Eigen::AlignedBox2d placed;
  for (int corner = 0; corner < 8; ++corner)
    placed.extend(
        (T * Eigen::Vector3d(
                 box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner)).cast<double>()))
            .head<2>());
  std::vector<Tile> tiles;
  for (int x = tileOf(placed.min().x(), edge); x <= tileOf(placed.max().x(), edge); ++x)
    for (int y = tileOf(placed.min().y(), edge); y <= tileOf(placed.max().y(), edge); ++y)
      tiles.emplace_back(x, y);
  return tiles;
}

/// Points with their intensities, or without any.
struct Cloud {
  Points points;
  std::vector<float> intensities;

  void add(const Eigen::Vector3f& point, const std::vector<float>& all, std::size_t i) {
    points.push_back(point);
    if (!all.empty()) intensities.push_back(all[i]);
  }
};

/// The detail of a submap placed at T, as far as it is in the tile.
Cloud within(const Tile& tile, double edge, const MapUpdate& submap, const Pose& T) {
  Cloud inside;
  for (std::size_t i = 0; i < submap.detail_submap.size(); ++i) {
    const Eigen::Vector3d placed = T * Eigen::Vector3d(submap.detail_submap[i].cast<double>());
    if (Tile{tileOf(placed.x(), edge), tileOf(placed.y(), edge)} == tile)
      inside.add(placed.cast<float>(), submap.intensities, i);
  }
  return inside;
}

/// With what is beside the tile and matters within.
Eigen::AlignedBox2f boxOf(const Tile& tile, double edge) {
  const Eigen::Vector2d corner(edge * tile.first, edge * tile.second);
  const Eigen::Array2d beside = Eigen::Array2d::Constant(kBesideTile);
  return {Eigen::Vector2f((corner.array() - beside).cast<float>()),
          Eigen::Vector2f((corner.array() + edge + beside).cast<float>())};
}

/// The points of a tile, one for each voxel.
struct TileCloud {
  explicit TileCloud(double voxel_size) : kept(voxel_size), dynamic(voxel_size) {}

  PointMap kept, dynamic;
};

void makeFolder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error("cannot make the folder '" + path + "': " + error.message());
}

/// One map, made once.
class MapExport {
 public:
  MapExport(const Session& session, const std::string& folder, const ExportConfig& config,
            const ExportProgress& progress)
      : session_(session),
        folder_(folder),
        config_(config),
        progress_(progress),
        parameters_(storedParameters(session.info)),
        scans_(scansOf(session.graph)) {}

  std::vector<std::string> run() {
    for (const std::string& format : config_.clouds)
      layouts_[format].frame = cloudFrameOf(config_.frame, session_.graph.georeference, format);
    makeFolder(folder_);
    if (config_.graph) writeGraphFiles();
    if (config_.submaps) writeSubmaps();
    if (!config_.clouds.empty() || (config_.occupancy && removesDynamic())) writeClouds();
    if (config_.occupancy && parameters_.occupancy.enabled && !session_.submaps.empty()) try {
        writeOccupancy();
      } catch (const std::invalid_argument& error) {  // submaps that do not fit together
        note(std::string("the map of the occupancy was not made: ") + error.what());
      }
    tell(1.0);
    return notices_;
  }

 private:
  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  const Pose& placeOf(const SubmapClosed& submap) const {
    return session_.graph.T_map_scan.at(scans_[submap.first_scan]);
  }
  void tell(double share) const {
    if (progress_) progress_(share);
  }

  void writeGraphFiles() {
    const Trajectory trajectory = trajectoryOf(session_.graph);
    writeTum(file("trajectory.tum"), trajectory);
    writeKitti(file("trajectory_kitti.txt"), trajectory);
    if (scans_.sessions().size() > 1) writeTrajectoryOfEach(trajectory);
    writeGraph(file("pose_graph.g2o"), session_.graph);
    writeLoops(file("loop_closures.csv"), session_.graph);
    if (session_.graph.georeference)
      writeGeoreference(folder_, trajectory, *session_.graph.georeference);
    makeFolder(file("submaps"));
    writeTable();
    tell(0.1);
  }

  void writeTrajectoryOfEach(const Trajectory& trajectory) const {
    for (const SessionId session : scans_.sessions()) {
      const auto begin = trajectory.begin() + static_cast<std::ptrdiff_t>(scans_.begin(session)),
                 end = trajectory.begin() + static_cast<std::ptrdiff_t>(scans_.end(session));
      writeTum(file("trajectory_" + std::to_string(session.value) + ".tum"),
               Trajectory(begin, end));
    }
  }

  /// Which scans a submap has, and where it lies.
  void writeTable() const {
    std::ostringstream table;
    table << "submap,local_map,first_scan,last_scan,stamp,x,y,z,qx,qy,qz,qw,session\n";
    for (const SubmapClosed& submap : session_.submaps) {
      const Eigen::Vector3d& t = placeOf(submap).translation;
      const Eigen::Quaterniond& q = placeOf(submap).rotation;
      char pose[256];
      std::snprintf(pose, sizeof(pose), "%.6f,%.6f,%.6f,%.9f,%.9f,%.9f,%.9f", t.x(), t.y(), t.z(),
                    q.x(), q.y(), q.z(), q.w());
      table << submap.id.value << "," << submap.local_map.value << "," << submap.first_scan.value
            << "," << submap.last_scan.value << "," << stampText(submap.stamp) << "," << pose << ","
            << submap.id.session.value << "\n";
    }
    writeWholeText(file("submaps/submaps.csv"), table.str());
  }

  /// What is wanted of a submap; nothing, and a notice, where its file cannot be used.
  MapUpdate read(const SubmapClosed& submap, const std::set<SubmapRecord>& wanted) {
    try {
      return readSubmap(submapFile(session_.folder, submap.id, session_.info.id), wanted);
    } catch (const std::runtime_error& error) {
      note(std::string(error.what()) + "; the map is without submap " +
           std::to_string(submap.id.value));
      return {};
    }
  }

  void note(const std::string& notice) {
    if (std::find(notices_.begin(), notices_.end(), notice) == notices_.end())
      notices_.push_back(notice);
  }

  void writeSubmaps() {
    makeFolder(file("submaps"));
    std::size_t done = 0;
    for (const SubmapClosed& submap : session_.submaps) {
      tell(0.1 + 0.2 * static_cast<double>(done++) / static_cast<double>(session_.submaps.size()));
      const MapUpdate stored = read(submap, kCloudRecords);
      const std::string name =
          std::filesystem::path(submapFile("", submap.id, session_.info.id)).stem().string();
      if (!stored.detail_submap.empty())
        writePcd(file("submaps/" + name + ".pcd"), stored.detail_submap, stored.intensities);
    }
  }

  bool removesDynamic() const {
    return config_.remove_dynamic || parameters_.mapping.dynamic_points.remove;
  }

  /// One point for each voxel, a tile of the map in memory at a time.
  void writeClouds() {
    const double edge = config_.tile.value_or(kTile);
    std::map<Tile, std::vector<const SubmapClosed*>> submaps_of_tile;
    for (const SubmapClosed& submap : session_.submaps)
      if (!submap.box_submap.isEmpty())
        for (const Tile& tile : tilesOf(submap.box_submap, placeOf(submap), edge))
          submaps_of_tile[tile].push_back(&submap);
    if (submaps_of_tile.empty()) return note("there is no map: no submap is closed");
    removeFormerClouds();
    const std::optional<float> strongest = strongestIntensity();
    for (auto& [format, layout] : layouts_) {
      layout.with_intensities = strongest.has_value();
      if (strongest && *strongest <= 1.0f) layout.intensity_scale = kSharesToWholeNumbers;
    }
    if (config_.tile) makeFolder(file("map_tiles"));
    std::size_t done = 0;
    const auto write_all = [&](auto then) {
      for (const auto& [tile, submaps] : submaps_of_tile) {
        const TileCloud cloud = merged(tile, edge, submaps);
        then(tile, cloud);
        if (removesDynamic()) dynamic_voxels_.add(cloud.kept.points(), cloud.dynamic.points());
        tell(0.3 + 0.5 * static_cast<double>(++done) / static_cast<double>(submaps_of_tile.size()));
      }
    };
    if (config_.tile)
      return write_all([&](const Tile& tile, const TileCloud& cloud) {
        writeTile("map", tile, cloud.kept);
        writeTile("map_dynamic", tile, cloud.dynamic);
      });
    // Streams of all formats at a time, so that submaps are read once.
    Outputs kept = outputsOf("map"), dynamic;
    if (removesDynamic()) dynamic = outputsOf("map_dynamic");
    write_all([&](const Tile&, const TileCloud& cloud) {
      for (const auto& output : kept)
        output->stream->write(cloud.kept.points(), cloud.kept.intensities());
      for (const auto& output : dynamic)
        output->stream->write(cloud.dynamic.points(), cloud.dynamic.intensities());
    });
    for (const auto& output : kept) output->finish();
    for (const auto& output : dynamic) output->finish();
  }

  /// A cloud that is there when it is whole.
  struct Output {
    Output(const std::string& format, const std::string& path, const CloudLayout& layout)
        : path(path),
          temporary(path + ".part"),
          stream(makeCloudStream(format, temporary, layout)) {}
    ~Output() { std::remove(temporary.c_str()); }
    void finish() {
      stream->finish();
      stream.reset();
      replaceWholeFile(temporary, path);
    }

    std::string path, temporary;
    std::unique_ptr<CloudStream> stream;
  };
  using Outputs = std::vector<std::unique_ptr<Output>>;

  Outputs outputsOf(const std::string& name) const {
    Outputs outputs;
    for (const std::string& format : config_.clouds)
      outputs.emplace_back(std::make_unique<Output>(format, file(name).append(".").append(format),
                                                    layouts_.at(format)));
    return outputs;
  }

  /// In the first and the last submaps of the sessions: a sensor that has intensities may have come
  /// in late. None where there are none.
  std::optional<float> strongestIntensity() {
    std::optional<float> strongest;
    const std::vector<SubmapClosed>& all = session_.submaps;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool is_first = i == 0 || all[i - 1].id.session != all[i].id.session;
      const bool is_last = i + 1 == all.size() || all[i + 1].id.session != all[i].id.session;
      if (!is_first && !is_last) continue;
      for (const float intensity : read(all[i], {SubmapRecord::intensities}).intensities)
        strongest = std::max(strongest.value_or(intensity), intensity);
    }
    return strongest;
  }

  TileCloud merged(const Tile& tile, double edge, const std::vector<const SubmapClosed*>& submaps) {
    std::optional<DynamicPointFilter> filter;
    if (removesDynamic()) filter = filterOf(boxOf(tile, edge), submaps);
    TileCloud cloud(
        std::max(config_.resolution.value_or(0.0), parameters_.mapping.detail_voxel_size));
    for (const SubmapClosed* submap : submaps) {
      const Cloud all = within(tile, edge, read(*submap, kCloudRecords), placeOf(*submap));
      Cloud kept, dynamic;
      for (std::size_t i = 0; i < all.points.size(); ++i) {
        const bool is_dynamic = filter && filter->isDynamic(all.points[i]);
        (is_dynamic ? dynamic : kept).add(all.points[i], all.intensities, i);
      }
      cloud.kept.insert(kept.points, Pose::identity(), kept.intensities);
      cloud.dynamic.insert(dynamic.points, Pose::identity(), dynamic.intensities);
    }
    return cloud;
  }

  DynamicPointFilter filterOf(const Eigen::AlignedBox2f& box_map,
                              const std::vector<const SubmapClosed*>& submaps) {
    DynamicPointFilter filter(parameters_.mapping.dynamic_points,
                              parameters_.mapping.detail_voxel_size, box_map);
    for (const SubmapClosed* submap : submaps) filter.add(seenPointsOf(*submap));
    for (const SubmapClosed* submap : submaps) filter.lookThrough(seenPointsOf(*submap));
    return filter;
  }

  SeenPoints seenPointsOf(const SubmapClosed& submap) {
    const MapUpdate update =
        read(submap, {SubmapRecord::trajectory, SubmapRecord::detail, SubmapRecord::sightings});
    if (update.submap && update.sightings.empty())
      note(
          "submaps of older software do not tell when their points were seen: what moved stays in "
          "the map where nothing else tells");
    return seenPoints(update, placeOf(submap), session_.submaps.front().stamp);
  }

  /// What an export with another edge, or of another map, or with what moved left there.
  void removeFormerClouds() const {
    for (const std::string& format : config_.clouds) {
      if (config_.tile) removeTiles(format);
      if (!removesDynamic()) std::filesystem::remove(file("map_dynamic." + format));
    }
  }

  void removeTiles(const std::string& format) const {
    const std::string folder = file("map_tiles");
    if (!std::filesystem::is_directory(folder)) return;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("map_", 0) == 0 && entry.path().extension() == "." + format)
        std::filesystem::remove(entry.path());
    }
  }

  void writeTile(const std::string& name, const Tile& tile, const PointMap& cloud) {
    if (cloud.points().empty()) return;
    const std::string numbers = std::to_string(tile.first) + "_" + std::to_string(tile.second);
    const std::string path = file("map_tiles/" + name + "_" + numbers + ".");
    for (const std::string& format : config_.clouds) {
      Output output(format, path + format, layouts_.at(format));
      output.stream->write(cloud.points(), cloud.intensities());
      output.finish();
    }
  }

  void writeOccupancy() {
    OccupancyVoxels map =
        composedOccupancy(session_, parameters_.occupancy, [this](const SubmapClosed& submap) {
          return read(submap, {SubmapRecord::occupancy}).occupancy;
        });
    if (removesDynamic()) dynamic_voxels_.clear(map);
    tell(0.9);
    writeOctree(map);
    writeProjectedGrid(map);
  }

  void writeOctree(const OccupancyVoxels& map) {
    removeTiles("bt");
    std::filesystem::remove(file("map_tiles/octomap.csv"));
    if (fitsOctree(map)) return writeOctomap(file("map.bt"), map);
    std::filesystem::remove(file("map.bt"));
    makeFolder(file("map_tiles"));
    std::ostringstream table;
    table << "file,x,y,z\n";
    forEachOctreeTile(map, [&](const OctreeTile& tile) {
      const std::string name =
          "map_" + std::to_string(tile.number.x()) + "_" + std::to_string(tile.number.y()) + ".bt";
      writeOctomap(file("map_tiles/" + name), *tile.tree);
      table << name << "," << tile.origin_map.x() << "," << tile.origin_map.y() << ","
            << tile.origin_map.z() << "\n";
    });
    writeWholeText(file("map_tiles/octomap.csv"), table.str());
    note(
        "map.bt was not made: the map is larger than an octree of 16 levels; it is in "
        "map_tiles/*.bt, whose origins are in map_tiles/octomap.csv");
  }

  void writeProjectedGrid(const OccupancyVoxels& map) {
    try {
      writeGrid(file("map"), projectedGrid(map, parameters_.occupancy.grid));
    } catch (const std::length_error& error) {  // no reason to leave out other files
      note(std::string("map.pgm was not made: ") + error.what());
    }
  }

  const Session& session_;
  const std::string folder_;
  const ExportConfig& config_;
  const ExportProgress& progress_;
  StoredParameters parameters_;
  const SessionOffsets<ScanId> scans_;
  std::map<std::string, CloudLayout> layouts_;  // of each format of clouds
  DynamicVoxels dynamic_voxels_{parameters_.occupancy.resolution};
  std::vector<std::string> notices_;
};

}  // namespace

std::vector<std::string> exportSession(const Session& session, const std::string& folder,
                                       const ExportConfig& config, const ExportProgress& progress) {
  const std::vector<SessionId> all = sessionsOf(session);
  if (all.size() < 2) return MapExport(session, folder, config, progress).run();
  const Session tied = tiedTo(all.front(), session);
  std::vector<std::string> notices = MapExport(tied, folder, config, progress).run();
  const std::vector<SessionId> left = sessionsOf(tied);
  for (const SessionId id : all)
    if (std::find(left.begin(), left.end(), id) == left.end())
      notices.push_back("session " + std::to_string(id.value) +
                        " is left out: no loop ties it to session " +
                        std::to_string(all.front().value));
  return notices;
}

MapConsistency consistencyOf(const Session& session) {
  if (sessionsOf(session).size() > 1) return {};  // their stamps are in no order
  ConsistencyConfig config;
  config.cell_size = kConsistencyCell;
  const SessionOffsets<ScanId> scans = scansOf(session.graph);
  ConsistencyBuilder builder(findRevisits(trajectoryOf(session.graph), config), config);
  for (const SubmapClosed& submap : session.submaps) {
    if (!builder.wants(submap.stamp)) continue;
    const std::string file = submapFile(session.folder, submap.id, session.info.id);
    try {
      builder.insert(submap.stamp, readSubmap(file, {SubmapRecord::detail}).detail_submap,
                     session.graph.T_map_scan.at(scans[submap.first_scan]));
    } catch (const std::runtime_error&) {
      // It is missing or damaged, and missing in the map, too, whose export says so.
    }
  }
  return builder.finish();
}

}  // namespace revisit_slam
