// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "revisit_slam/session/session_reader.h"
#include "support/simulated_slam.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

struct Mapped {
  std::string drive, graph;  // bytes of the logs
  std::size_t loops = 0;
  std::size_t bytes = 0, all_bytes = 0;  // of submaps in memory at the end, and of all
};

/// A drive there and back, with so much room for submaps.
Mapped map(const InformedDrive& drive, int cache_mb) {
  const TemporaryFolder folder;
  SlamConfig config;
  config.mapping.cache_mb = cache_mb;
  SlamRecorder recorder;
  InlineExecutor executor;
  Slam slam(config, recorder, executor, [&](SessionId, Stamp) {
    return SessionTarget{folder.file("session"), "", nullptr, false};
  });
  for (const InformedScan& scan : drive.scans) slam.insert(scan);
  slam.finish();
  slam.session()->writeRest();
  Mapped mapped;
  mapped.drive = textOf(graphLogFile(folder.file("session")));
  mapped.graph = textOf(optimisationsFile(folder.file("session")));
  mapped.loops = activeLoops(slam.session()->graph());
  mapped.bytes = recorder.maps.front().library->bytes();
  for (const MapUpdate& update : recorder.maps)
    mapped.all_bytes +=
        2 * update.submap->points.size() * sizeof(Eigen::Vector3f) + update.occupancy->bytes();
  return mapped;
}

TEST(SubmapCache, TheRoomThatIsStatedIsEnoughForTheSameBytes) {
  const InformedDrive drive =
      simulateInformedDrive("opposite", 500.0, "spinning-64", 256, 1, SlamConfig{});
  const Mapped roomy = map(drive, 1000), tight = map(drive, 1);
  EXPECT_EQ(roomy.bytes, roomy.all_bytes);
  EXPECT_GT(roomy.all_bytes, 2'000'000u);
  EXPECT_LE(tight.bytes, 1'000'000u);
  EXPECT_GT(roomy.loops, 5u);
  EXPECT_TRUE(tight.drive == roomy.drive);
  EXPECT_TRUE(tight.graph == roomy.graph);
}

}  // namespace
}  // namespace revisit_slam
