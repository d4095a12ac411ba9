// SPDX-License-Identifier: MIT
#include "closed_drive.h"

#include <tbb/task_arena.h>

#include "revisit_slam/util/process_usage.h"
#include "revisit_slam/slam/back_end.h"

namespace revisit_slam {
namespace {

double timeOf(const StageTimes& times, const std::string& stage) {
  for (const auto& [name, ms] : times)
    if (name == stage) return ms;
  return 0.0;
}

}  // namespace

ClosedDrive closeLoops(const MappedDrive& drive, const SlamConfig& config) {
  ClosedDrive closed;
  std::vector<LoopProposal> retroactive;
  const auto keep = [&](const std::vector<LoopProposal>& proposals) {
    retroactive.insert(retroactive.end(), proposals.begin(), proposals.end());
  };
  LoopSearch search(config.loops, config.information);
  BackEnd back_end(
      config, [](const MapCorrectionPtr&) {}, keep);
  tbb::task_arena arena(config.background.threads);
  auto node = drive.nodes.begin();
  for (const LocalMapPtr& map : drive.maps) {
    while (node != drive.nodes.end() && !(map->submaps.back()->lastScan() < node->id))
      back_end.add(*node++);
    MapClosure closure;
    const BackEndCount before = back_end.count();
    const double cpu_before = processCpuSeconds();
    arena.execute([&] {
      closure.search = search.search(map);
      back_end.add(map, closure.search.accepted());
    });
    const BackEndCount& after = back_end.count();
    closure.recognition_ms = timeOf(closure.search.times, "recognition");
    closure.registration_ms = timeOf(closure.search.times, "registration");
    closure.retroactive_ms = 1e3 * (after.retroactive_seconds - before.retroactive_seconds);
    closure.optimisation_ms = 1e3 * (after.optimisation_seconds - before.optimisation_seconds);
    closure.cpu_ms = 1e3 * (processCpuSeconds() - cpu_before) - closure.optimisation_ms;
    closure.retroactive = std::exchange(retroactive, {});
    closed.maps.push_back(std::move(closure));
  }
  arena.execute([&] { back_end.finish(); });
  closed.at_the_end = retroactive;
  closed.edges = back_end.graph().loops();
  closed.trajectory = back_end.trajectory();
  return closed;
}

}  // namespace revisit_slam
