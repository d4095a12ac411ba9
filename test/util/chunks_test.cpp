// SPDX-License-Identifier: MIT
#include "revisit_slam/util/chunks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "support/threads.h"

namespace revisit_slam {
namespace {

TEST(Chunks, CoverEveryIndexOnceInFixedCutsForAnyNumberOfThreads) {
  for (const std::size_t count : {0u, 1u, 255u, 256u, 257u, 10000u})
    for (const int threads : {1, 2, 4}) {
      const Chunks chunks(count, 256);
      std::vector<std::atomic<int>> visits(count);
      onThreads(threads, [&] {
        chunks.forEach([&](std::size_t index, Chunk chunk) {
          EXPECT_EQ(chunk.begin, 256 * index);
          EXPECT_LE(chunk.end - chunk.begin, 256u);
          for (std::size_t i = chunk.begin; i < chunk.end; ++i) ++visits[i];
        });
      });
      for (const auto& visit : visits) ASSERT_EQ(visit, 1);
    }
}

}  // namespace
}  // namespace revisit_slam
