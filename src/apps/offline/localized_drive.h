// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "revisit_slam/localization/localization_log.h"
#include "revisit_slam/session/run_folder.h"
#include "revisit_slam/slam/localization_stage.h"

namespace revisit_slam {

/// Localizes a drive in the map of an earlier session, and writes where each scan was by all that
/// was known when it came.
class LocalizedDrive {
 public:
  using Say = std::function<void(const std::string&)>;

  /// @throws std::runtime_error where there is no map to use.
  LocalizedDrive(const SlamConfig& config, const RunFolder& folder, Say say);

  void add(const InformedScan& informed);
  /// @throws std::runtime_error naming a file that cannot be written.
  void finish();

 private:
  void saySo(const Localization& now);

  const Say say_;
  std::vector<std::string> notices_;  // of the map
  LocalizationStage stage_;
  LocalizationLog log_;
  LocalizationState said_ = LocalizationState::searching;
};

}  // namespace revisit_slam
