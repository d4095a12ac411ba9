// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/cross_registration.h"

#include <tbb/task_arena.h>

#include <map>
#include <memory>
#include <stdexcept>

#include "revisit_slam/loops/acceptance/loop_closer.h"
#include "revisit_slam/session/known_map.h"

namespace revisit_slam {
namespace {

/// Local maps of a folder, read when they are asked for.
class LocalMaps {
 public:
  LocalMaps(const std::string& folder, SessionId session) : session_(session) {
    std::vector<std::string> notices;  // said when the session was summarised
    stored_ = readSession(folder, notices);
  }

  const LocalMap& operator[](LocalMapId id) {
    auto& map = maps_[id];
    if (map != nullptr) return *map;
    map = std::make_shared<LocalMap>();
    map->id = {id.value, session_};
    for (const SubmapClosed& closed : stored_.submaps)
      if (closed.local_map == id) map->submaps.push_back(read(closed));
    if (map->submaps.empty())
      throw std::runtime_error("the session '" + stored_.folder + "' has no local map " +
                               std::to_string(id.value));
    return *map;
  }

 private:
  /// With the number of a session of its own, so that no two are of one drive.
  SubmapPtr read(const SubmapClosed& closed) const {
    auto submap = std::make_shared<Submap>(readForLoops(stored_.folder, stored_.info.id, closed));
    submap->id.session = submap->local_map.session = submap->first_scan.session = session_;
    return submap;
  }

  SessionId session_;
  Session stored_;
  std::map<LocalMapId, std::shared_ptr<LocalMap>> maps_;
};

/// With the ids of the folders.
LoopConstraint withOwnIds(LoopConstraint loop) {
  for (ScanId* id : {&loop.constraint.from, &loop.constraint.to}) id->session = {};
  for (SubmapId* id : {&loop.target, &loop.source}) id->session = {};
  for (LocalMapId* id : {&loop.target_map, &loop.source_map}) id->session = {};
  return loop;
}

}  // namespace

SessionCrossing registerMatches(const NamedSession& source, const NamedSession& target,
                                const std::vector<PlaceMatch>& matches, const SlamConfig& config) {
  SessionCrossing crossing{source.name, target.name, {}, {}};
  LocalMaps sources(source.folder, SessionId{1}), targets(target.folder, SessionId{0});
  const LoopCloser closer(config.loops.closer, config.information);
  tbb::task_arena(config.background.threads).execute([&] {
    for (const PlaceMatch& match : matches)
      for (const LoopProposal& proposal :
           closer.close(sources[match.source], targets[match.target], match.T_target_source,
                        LoopOrigin::appearance)) {
        ++crossing.outcomes[proposal.verdict.outcome()];
        if (!proposal.verdict.isAccepted()) continue;
        LoopConstraint loop = withOwnIds(proposal.loop);
        loop.inliers = match.inliers;
        crossing.loops.push_back(loop);
      }
  });
  return crossing;
}

}  // namespace revisit_slam
