// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace revisit_slam {

/// While the result lives, arenas get the threads that they ask for, also on a machine with fewer.
inline tbb::global_control moreThreadsThanCores() {
  return {tbb::global_control::max_allowed_parallelism, 8};
}

/// What work() returns when it runs in an arena of this many threads.
template <typename Work>
auto onThreads(int threads, const Work& work) {
  const auto allowed = moreThreadsThanCores();
  tbb::task_arena arena(threads);
  return arena.execute(work);
}

}  // namespace revisit_slam
