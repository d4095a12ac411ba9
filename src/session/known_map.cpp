// SPDX-License-Identifier: MIT
#include "revisit_slam/session/known_map.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "revisit_slam/session/stored_submap.h"

namespace revisit_slam {
namespace {

/// Scans that are in no closed submap cannot be registered to anything.
void cutToClosedSubmaps(Session& session) {
  std::set<ScanId> last;
  for (const SubmapClosed& submap : session.submaps) last.insert(submap.last_scan);
  SessionGraph& graph = session.graph;
  SessionGraph cut;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const ScanId id = graph.nodes[i].id;
    const auto end = last.lower_bound(id);
    if (end == last.end() || end->session != id.session) continue;
    cut.nodes.push_back(graph.nodes[i]);
    cut.T_map_scan.push_back(graph.T_map_scan[i]);
  }
  cut.T_map_odom = graph.T_map_odom;
  cut.georeference = graph.georeference;
  cut.loops = std::move(graph.loops);
  graph = std::move(cut);
}

/// Also those without a closed submap.
std::vector<SessionId> allSessionsOf(const Session& session) {
  const std::vector<SessionId> with_scans = sessionsOf(session);
  std::set<SessionId> all(with_scans.begin(), with_scans.end());
  all.insert(session.info.id);
  for (const JoinedSession& joined : session.info.joined) all.insert(joined.id);
  return {all.begin(), all.end()};
}

class KnownMapReader {
 public:
  KnownMapReader(const PlaceRecognitionConfig& recognition, std::vector<std::string>& notices,
                 KnownMap& map)
      : recognition_(recognition), notices_(notices), map_(map) {}

  void read() {
    for (const SubmapClosed& closed : map_.session.submaps) {
      if (map_.maps.empty() || map_.maps.back()->id != map_.numbers(closed.local_map))
        beginLocalMap(closed.local_map);
      readOne(closed);
    }
  }

 private:
  const std::string& folder() const { return map_.session.folder; }
  SessionId owner() const { return map_.session.info.id; }

  void beginLocalMap(LocalMapId id) {
    open_ = std::make_shared<LocalMap>();
    open_->id = map_.numbers(id);
    map_.maps.push_back(open_);
    PlaceView view;
    view.id = open_->id;
    try {
      const StoredLocalMap stored = readLocalMap(localMapFile(folder(), id, owner()));
      if (stored.features.size() > 0 && stored.pixel != recognition_.image.resolution)
        throw std::runtime_error("its loops/recognition/image/resolution was " +
                                 std::to_string(stored.pixel));
      view.T_level_local = stored.T_level_local;
      view.features = stored.features;
    } catch (const std::exception& error) {
      notices_.push_back("place " + std::to_string(id.value) +
                         " is not recognised: " + error.what());
    }
    map_.places.push_back(std::move(view));
  }

  void readOne(const SubmapClosed& closed) {
    const auto read = [folder = folder(), owner = owner(), numbers = map_.numbers, closed] {
      return numbers(readForLoops(folder, owner, closed));
    };
    const auto submap = std::make_shared<const Submap>(read());
    map_.library->add(submap, nullptr);
    map_.library->noteStored(submap->id, read);
    open_->submaps.push_back(map_.library->light(submap->id));
  }

  const PlaceRecognitionConfig& recognition_;
  std::vector<std::string>& notices_;
  KnownMap& map_;
  std::shared_ptr<LocalMap> open_;  // the last of the map's
};

/// The points that loops are registered with; null where they can no longer be read either.
std::shared_ptr<MapUpdate> readForLoopsAgain(const KnownMap& map, SubmapId id) {
  try {
    auto update = std::make_shared<MapUpdate>();
    update->submap = map.library->whole(id);
    update->detail_submap = update->submap->points;
    return update;
  } catch (const std::runtime_error&) {
    return nullptr;
  }
}

/// All that its file has; the points that loops are registered with where the rest is damaged.
std::shared_ptr<MapUpdate> readAll(const KnownMap& map, const SubmapClosed& closed, SubmapId id) {
  const Session& session = map.session;
  try {
    return std::make_shared<MapUpdate>(map.numbers(
        readSubmap(submapFile(session.folder, closed.id, session.info.id),
                   {SubmapRecord::trajectory, SubmapRecord::points, SubmapRecord::normals,
                    SubmapRecord::detail, SubmapRecord::occupancy, SubmapRecord::sightings,
                    SubmapRecord::intensities})));
  } catch (const std::runtime_error&) {
    return readForLoopsAgain(map, id);
  }
}

}  // namespace

Submap readForLoops(const std::string& folder, SessionId owner, const SubmapClosed& closed) {
  Submap submap =
      *readSubmap(submapFile(folder, closed.id, owner),
                  {SubmapRecord::trajectory, SubmapRecord::points, SubmapRecord::normals})
           .submap;
  if (submap.id != closed.id || submap.points.size() != submap.normals.size() ||
      submap.first_scan != closed.first_scan ||
      submap.T_submap_scan.size() != closed.last_scan.value - closed.first_scan.value + 1)
    throw std::runtime_error("submap " + std::to_string(closed.id.value) +
                             " is not the one that the log tells of");
  return submap;
}

SessionId nextSession(const SessionInfo& info) {
  SessionId next = info.id;
  for (const JoinedSession& joined : info.joined) next = std::max(next, joined.id);
  ++next.value;
  return next;
}

KnownMap readKnownMap(const std::string& folder, std::optional<SessionId> first,
                      const PlaceRecognitionConfig& recognition,
                      std::vector<std::string>& notices) {
  try {
    // Submaps are read later, too, wherever a link points then.
    Session session = readSession(std::filesystem::weakly_canonical(folder).string(), notices);
    cutToClosedSubmaps(session);
    if (session.submaps.empty()) throw std::runtime_error("it has no closed submap");
    const SessionNumbers numbers(allSessionsOf(session), first);
    KnownMap map{std::move(session), numbers, {}, {}, {}, {}, std::make_shared<SubmapLibrary>(0)};
    for (const GraphNode& node : map.session.graph.nodes) map.nodes.push_back(numbers(node));
    for (const LoopEdge& edge : map.session.graph.loops) map.loops.push_back(numbers(edge));
    KnownMapReader(recognition, notices, map).read();
    return map;
  } catch (const std::exception& error) {
    throw std::runtime_error("the session '" + folder + "' cannot be used: " + error.what());
  }
}

SessionInfo infoOfAll(const std::vector<const KnownMap*>& maps) {
  SessionInfo info = maps.front()->session.info;
  info.joined.clear();
  info.closed = false;
  for (const KnownMap* map : maps) {
    const SessionInfo& own = map->session.info;
    info.joined.push_back({map->numbers(own.id), own.start, own.sensor, map->session.folder});
    for (JoinedSession joined : own.joined) {
      joined.id = map->numbers(joined.id);
      info.joined.push_back(std::move(joined));
    }
  }
  info.id = info.joined.front().id;
  info.joined.erase(info.joined.begin());
  return info;
}

void copyMaps(const KnownMap& map, SessionWriter& writer, bool reads_copies) {
  const Session& session = map.session;
  const SessionNumbers& numbers = map.numbers;
  std::set<LocalMapId> local_maps;
  std::vector<SubmapPtr> submaps;
  for (const LocalMapPtr& local_map : map.maps)
    submaps.insert(submaps.end(), local_map->submaps.begin(), local_map->submaps.end());
  auto node = map.nodes.begin();
  for (std::size_t i = 0; i < submaps.size(); ++i) {
    const SubmapClosed& closed = session.submaps[i];
    const std::shared_ptr<MapUpdate> update = readAll(map, closed, submaps[i]->id);
    const std::uint32_t scans = closed.last_scan.value - closed.first_scan.value + 1;
    const auto end = node + scans;
    if (update && reads_copies) update->library = map.library;
    writer.add({node, end}, numbers(closed), update);
    writer.drain();  // one in memory at a time
    node = end;
    local_maps.insert(closed.local_map);
  }
  for (const LocalMapId id : local_maps) {
    try {
      writer.add(numbers(readLocalMap(localMapFile(session.folder, id, session.info.id))));
    } catch (const std::exception&) {
      continue;  // said when the map was read
    }
  }
}

}  // namespace revisit_slam
