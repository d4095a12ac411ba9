// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/executor.h"

namespace revisit_slam {
namespace {

/// Tasks that may wait: a few local maps. Most are graph nodes, which are light.
constexpr std::size_t kMostWaiting = 200;

}  // namespace

StagedExecutor::StagedExecutor(const BackgroundConfig& config)
    : lane_(
          config.niceness,
          [this](std::exception_ptr error) {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!error_) error_ = error;
            lane_.discard();  // finish() throws it: the rest would be in vain
          },
          kMostWaiting) {}

void StagedExecutor::finish() {
  lane_.drain();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (error_) std::rethrow_exception(error_);
}

}  // namespace revisit_slam
