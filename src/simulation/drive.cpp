// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/drive.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <utility>

#if __has_include(<tbb/parallel_pipeline.h>)
#include <tbb/parallel_pipeline.h>
using FilterMode = tbb::filter_mode;
#else  // TBB before 2021
#include <tbb/pipeline.h>
using FilterMode = tbb::filter;
#endif

namespace revisit_slam::simulation {
namespace {

struct Item {
  int index = 0;
  std::shared_ptr<const SimulatedScan> scan;
};

}  // namespace

int scanCount(const Route& route, int max_scans) {
  const std::int64_t duration = route.end().nanoseconds - route.start().nanoseconds;
  const int whole = static_cast<int>(duration / SensorModel::kPeriodNanoseconds);
  return max_scans > 0 ? std::min(whole, max_scans) : whole;
}

Stamp scanStart(const Route& route, int index) {
  return {route.start().nanoseconds + index * SensorModel::kPeriodNanoseconds};
}

void simulateDrive(const ScanSimulator& simulator, const Route& route, int count, int threads,
                   const std::function<void(int, const SimulatedScan&)>& consume) {
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  const auto tokens = static_cast<std::size_t>(2 * arena.max_concurrency());
  int next = 0;
  const auto enumerate = [&](tbb::flow_control& control) {
    if (next == count) control.stop();
    return next++;
  };
  const auto simulate = [&](int index) {
    return Item{index,
                std::make_shared<const SimulatedScan>(simulator.simulate(scanStart(route, index)))};
  };
  const auto hand_over = [&](const Item& item) { consume(item.index, *item.scan); };
  arena.execute([&] {
    tbb::parallel_pipeline(
        tokens, tbb::make_filter<void, int>(FilterMode::serial_in_order, enumerate) &
                    tbb::make_filter<int, Item>(FilterMode::parallel, simulate) &
                    tbb::make_filter<Item, void>(FilterMode::serial_in_order, hand_over));
  });
}

}  // namespace revisit_slam::simulation
