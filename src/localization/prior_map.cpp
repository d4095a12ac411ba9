// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/prior_map.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "revisit_slam/session/known_map.h"
#include "revisit_slam/session/session_reader.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {
namespace {

/// Reads what a session has, piece by piece, and names what it has not.
class PriorMapReader {
 public:
  PriorMapReader(const std::string& folder, const PlaceRecognitionConfig& recognition,
                 std::size_t cache_bytes, std::vector<std::string>& notices)
      : session_(readSession(std::filesystem::weakly_canonical(folder).string(), notices)),
        recognition_(recognition),
        notices_(notices) {
    map_.library = std::make_shared<SubmapLibrary>(cache_bytes);
  }

  PriorMap read() {
    session_ = tiedTo(session_.info.id, std::move(session_));
    scans_ = scansOf(session_.graph);
    map_.info = session_.info;
    map_.T_map_scan = session_.graph.T_map_scan;
    map_.georeference = session_.graph.georeference;
    std::set<LocalMapId> places;
    for (const SubmapClosed& submap : session_.submaps) {
      attempt([&] { readOne(submap); }, "without submap " + std::to_string(submap.id.value));
      places.insert(submap.local_map);
    }
    for (const LocalMapId id : places)
      attempt([&] { readPlace(id); }, "place " + std::to_string(id.value) + " is not recognised");
    return std::move(map_);
  }

 private:
  template <typename Work>
  void attempt(const Work& work, const std::string& consequence) {
    try {
      work();
    } catch (const std::exception& error) {
      notices_.push_back(consequence + ": " + error.what());
    }
  }

  void readOne(const SubmapClosed& closed) {
    const auto read = [folder = session_.folder, owner = session_.info.id, closed] {
      return readForLoops(folder, owner, closed);
    };
    const auto submap = std::make_shared<const Submap>(read());
    const Pose& T_map_submap = session_.graph.T_map_scan.at(scans_[closed.first_scan]);
    T_map_submap_[closed.id] = T_map_submap;
    map_.library->add(submap, nullptr);
    map_.library->noteStored(submap->id, read);
    map_.submaps.push_back({map_.library->light(submap->id), T_map_submap});
  }

  void readPlace(LocalMapId id) {
    StoredLocalMap place = readLocalMap(localMapFile(session_.folder, id, session_.info.id));
    if (place.submaps.empty() || place.features.size() == 0)
      throw std::runtime_error("it has no features");
    if (place.pixel != recognition_.image.resolution)
      throw std::runtime_error("its loops/recognition/image/resolution was " +
                               std::to_string(place.pixel));
    const auto first = T_map_submap_.find(place.submaps.front());
    if (first == T_map_submap_.end()) throw std::runtime_error("its first submap is missing");
    map_.T_map_place.push_back(first->second);
    map_.places.push_back(std::move(place));
  }

  Session session_;
  SessionOffsets<ScanId> scans_;
  const PlaceRecognitionConfig& recognition_;
  std::vector<std::string>& notices_;
  PriorMap map_;
  std::map<SubmapId, Pose> T_map_submap_;
};

const Pose& nearest(const std::vector<Pose>& poses, double x, double y) {
  const Pose* best = &poses.front();
  const auto distance = [&](const Pose& T) {
    return std::hypot(T.translation.x() - x, T.translation.y() - y);
  };
  for (const Pose& T : poses)
    if (distance(T) < distance(*best)) best = &T;
  return *best;
}

}  // namespace

PlacedSubmap PriorMap::whole(const PlacedSubmap& placed) const {
  return {library->whole(placed.submap->id), placed.T_common_submap};
}

Pose PriorMap::onGround(double x, double y, double yaw) const {
  const Pose& near = nearest(T_map_scan, x, y);
  const Eigen::Vector3d up = near.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d heading(std::cos(yaw), std::sin(yaw), 0.0);
  Eigen::Matrix3d R;
  R.col(2) = up;
  R.col(0) = (heading - up.dot(heading) * up).normalized();
  R.col(1) = up.cross(R.col(0));
  // On the plane through the nearest scan.
  const Eigen::Vector2d aside = Eigen::Vector2d(x, y) - near.translation.head<2>();
  const double z = near.translation.z() - up.head<2>().dot(aside) / up.z();
  return {Eigen::Quaterniond(R).normalized(), {x, y, z}};
}

double PriorMap::distanceTo(const Eigen::Vector3d& position) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Pose& T : T_map_scan) least = std::min(least, (T.translation - position).norm());
  return least;
}

PriorMapPtr loadPriorMap(const std::string& folder, const PlaceRecognitionConfig& recognition,
                         std::size_t cache_bytes, std::vector<std::string>& notices) {
  PriorMap map = PriorMapReader(folder, recognition, cache_bytes, notices).read();
  if (map.submaps.empty())
    throw std::runtime_error("the session '" + folder + "' has no submap that can be used");
  return std::make_shared<const PriorMap>(std::move(map));
}

std::optional<Pose> startPose(const std::string& start, const PriorMap& map) {
  std::istringstream text(start);
  std::vector<double> values;
  for (double value; text >> value;) values.push_back(value);
  if (!text.eof() || (values.size() != 0 && values.size() != 3 && values.size() != 6))
    throw ParameterError("localization/start = '" + start +
                         "': must be x y yaw, x y z roll pitch yaw, or empty");
  if (values.empty()) return std::nullopt;
  if (values.size() == 3) return map.onGround(values[0], values[1], values[2]);
  using Eigen::AngleAxisd;
  const Eigen::Quaterniond rotation = AngleAxisd(values[5], Eigen::Vector3d::UnitZ()) *
                                      AngleAxisd(values[4], Eigen::Vector3d::UnitY()) *
                                      AngleAxisd(values[3], Eigen::Vector3d::UnitX());
  return Pose{rotation, {values[0], values[1], values[2]}};
}

}  // namespace revisit_slam
