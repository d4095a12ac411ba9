// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/session_merge.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "revisit_slam/slam/map_correction.h"
#include "revisit_slam/types/session_groups.h"

namespace revisit_slam {
namespace {

std::shared_ptr<SubmapLibrary> libraryOf(const SlamConfig& config,
                                         const std::vector<KnownMap>& maps) {
  auto library = std::make_shared<SubmapLibrary>(config.mapping.cacheBytes());
  for (const KnownMap& map : maps) library->addStored(map.library);
  return library;
}

SlamConfig withDatumOf(const KnownMap& first, SlamConfig config) {
  config.gnss = config.gnss.withDatumOf(first.session.info.datum);
  return config;
}

}  // namespace

SessionMerge::SessionMerge(const SlamConfig& config, const std::vector<KnownMap>& maps,
                           OnSearch on_search)
    : config_(withDatumOf(maps.front(), config)),
      maps_(maps),
      graph_(config_.backend, config_.gnss, config_.gravity),
      closing_(config_, outputs(std::move(on_search)), libraryOf(config, maps)) {
  addMaps();
  const ScanId last = graph_.nodes().back().id;
  tbb::task_arena(config.background.threads).execute([&] {
    for (std::size_t i = 1; i < maps_.size(); ++i)
      for (const LocalMapPtr& map : maps_[i].maps)
        lane_.post([this, i, map] { closing_.searchAcrossSessions(map->id, sessionOf(i)); });
    lane_.post([this, last] { closing_.finish({last.session, last.value + 1, 0}); });
  });
}

void SessionMerge::addMaps() {
  std::vector<const KnownMap*> maps;
  for (const KnownMap& map : maps_) {
    graph_.addOptimised(map.nodes, map.session.graph.T_map_scan, map.loops);
    maps.push_back(&map);
  }
  closing_.goOnFrom(maps);
}

LoopClosing::Outputs SessionMerge::outputs(OnSearch on_search) {
  LoopClosing::Outputs outputs;
  outputs.search = std::move(on_search);
  outputs.closures = [this](const LoopClosures& closures) {
    if (closures.request != 0) lane_.post([this, closures] { answer(closures); });
  };
  outputs.closed = [](const MapsClosed&) {};
  outputs.problem = [](const std::string& problem) { throw std::runtime_error(problem); };
  return outputs;
}

void SessionMerge::answer(const LoopClosures& closures) {
  if (closures.constraints.empty() && !graph_.hasNewMeasurements(closures.last_scan))
    return closing_.correct(unchangedMap(closures.map.session, closures.request));
  graph_.optimise(closures.last_scan, closures.constraints);
  MapCorrection correction = correctionOf(graph_, closures.last_scan);
  correction.version = closures.request;
  correction.request = closures.request;
  closing_.correct(std::make_shared<const MapCorrection>(std::move(correction)));
}

SessionId SessionMerge::sessionOf(std::size_t map) const {
  return maps_[map].numbers(maps_[map].session.info.id);
}

std::vector<std::size_t> SessionMerge::joined() const {
  const SessionGroups groups(graph_.loops());
  std::vector<std::size_t> most;
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    std::vector<std::size_t> tied;
    for (std::size_t k = 0; k < maps_.size(); ++k)
      if (groups.areTied(sessionOf(i), sessionOf(k))) tied.push_back(k);
    if (tied.size() > most.size()) most = std::move(tied);
  }
  return most;
}

/// Of the first map: positions count there (GnssFactors).
std::optional<Georeference> SessionMerge::georeference() const {
  if (!isJoined(0)) return std::nullopt;
  const std::optional<Georeference> optimised = graph_.georeference();
  return optimised ? optimised : maps_.front().session.graph.georeference;
}

bool SessionMerge::isJoined(std::size_t map) const {
  const std::vector<std::size_t> all = joined();
  return std::find(all.begin(), all.end(), map) != all.end();
}

void SessionMerge::write(const std::string& folder) const {
  std::vector<const KnownMap*> maps;
  for (const std::size_t i : joined()) maps.push_back(&maps_[i]);
  SessionInfo info = infoOfAll(maps);
  SlamConfig config = config_;
  info.software = softwareVersion();
  const std::optional<Georeference> georeference = this->georeference();
  info.datum.reset();
  if (georeference) info.datum = georeference->datum;
  info.parameters = textOf(parametersOf(config));
  SessionWriter writer({folder, info.sensor, nullptr, false}, info, config_.background.niceness);
  SessionsTakenOver taken;
  SessionOffsets<ScanId> scans;
  for (const KnownMap* map : maps) {
    copyMaps(*map, writer);
    for (const GraphNode& node : map->nodes) {
      scans.append(node.id);
      taken.T_map_scan.push_back(graph_.pose(node.id));
    }
  }
  for (LoopEdge edge : graph_.loops()) {
    if (!scans.contains(edge.loop.constraint.from) || !scans.contains(edge.loop.constraint.to))
      continue;
    edge.id.value = static_cast<std::uint32_t>(taken.loops.size());
    taken.loops.push_back(edge);
  }
  writer.add(LogEntry(std::move(taken)));
  if (georeference) writer.add(LogEntry(MapGeoreferenced{0, *georeference}));
  writer.close();
  writer.drain();
  if (!writer.problem().empty()) throw std::runtime_error(writer.problem());
}

}  // namespace revisit_slam
