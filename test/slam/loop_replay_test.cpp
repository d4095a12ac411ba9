// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/loop_replay.h"

#include <gtest/gtest.h>

#include "revisit_slam/session/session_graph.h"
#include "support/simulated_slam.h"

namespace revisit_slam {
namespace {

const InformedDrive& drive() {
  static const InformedDrive drive =
      simulateInformedDrive("opposite", 1000.0, "spinning-64", 256, 5, SlamConfig{});
  return drive;
}

struct WholeRun {
  explicit WholeRun(const SlamConfig& config) : slam(config, recorder, executor) {
    for (const InformedScan& scan : drive().scans) slam.insert(scan);
    slam.finish();
  }
  SlamRecorder recorder;
  InlineExecutor executor;
  Slam slam;
};

/// Of a run without loops.
const MappedDrive& mapped() {
  static const MappedDrive mapped = [] {
    SlamConfig config;
    config.loops.enabled = false;
    const WholeRun run(config);
    MappedDrive drive_of_maps;
    for (const InformedScan& scan : drive().scans) drive_of_maps.nodes.push_back(nodeOf(scan));
    for (const MapUpdate& update : run.recorder.maps)
      if (update.local_map) drive_of_maps.maps.push_back(update.local_map);
    return drive_of_maps;
  }();
  return mapped;
}

TEST(LoopReplay, GivesTheBitsOfTheWholeRun) {
  for (const bool with_feedback : {true, false}) {
    SlamConfig config;
    config.retroactive.enabled = with_feedback;
    const WholeRun whole(config);
    const LoopReplay replay(mapped(), config);
    const Trajectory expected = trajectoryOf(graphOf(whole.slam.session()->graph())),
                     replayed = trajectoryOf(graphOf(replay.graph()));
    EXPECT_FALSE(replay.graph().loops().empty());
    ASSERT_EQ(replayed.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_EQ(replayed[i].T_world_base.matrix(), expected[i].T_world_base.matrix()) << i;
  }
}

TEST(LoopReplay, PutsTheIdentityInThePlaceOfInformationThatIsSwitchedOff) {
  SlamConfig config;
  config.information.enabled = false;
  const LoopReplay replay(mapped(), config);
  EXPECT_EQ(replay.graph().node({5}).information, Matrix6(Matrix6::Identity()));
  for (const LoopEdge& edge : replay.graph().loops())
    EXPECT_EQ(edge.loop.constraint.information, Matrix6(Matrix6::Identity()));
}

}  // namespace
}  // namespace revisit_slam
