// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/loop_replay.h"

#include <tbb/task_arena.h>

#include <stdexcept>

namespace revisit_slam {

LoopReplay::LoopReplay(const MappedDrive& drive, const SlamConfig& config)
    : session_(drive.nodes.at(0).id.session, config, drive.nodes[0].stamp, {},
               [this](const MapCorrectionPtr& correction) {
                 lane_.post([this, correction] { closing_.correct(correction); });
               }),
      closing_(config, outputs()) {
  for (GraphNode node : drive.nodes) {
    if (!config.information.enabled) node.information = Matrix6::Identity();
    session_.add(node);
  }
  tbb::task_arena(config.background.threads).execute([&] {
    for (const LocalMapPtr& map : drive.maps) lane_.post([this, map] { closing_.add(map); });
    const auto scans = static_cast<std::uint32_t>(drive.nodes.size());
    lane_.post([this, scans] { closing_.finish({session_.id(), scans, 0}); });
  });
}

LoopClosing::Outputs LoopReplay::outputs() {
  LoopClosing::Outputs outputs;
  outputs.search = [](const LoopSearchResult&) {};
  outputs.closures = [this](const LoopClosures& closures) {
    lane_.post([this, closures] { session_.add(closures); });
  };
  outputs.closed = [](const MapsClosed&) {};
  outputs.problem = [](const std::string& problem) { throw std::runtime_error(problem); };
  return outputs;
}

}  // namespace revisit_slam
