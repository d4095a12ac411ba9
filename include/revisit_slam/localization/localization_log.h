// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/io/line_file.h"
#include "revisit_slam/localization/localization_state.h"

namespace revisit_slam {

/// Where each scan of a drive was by all that was known when it came, on disk as soon as it is
/// known: localized.tum, from the first fix on, and localization.csv in a folder.
class LocalizationLog {
 public:
  explicit LocalizationLog(const std::string& folder);

  void add(const Localization& now);
  /// Writes lines that wait. @throws std::runtime_error naming the file that cannot be written.
  void flush();
  /// Why lines wait; empty: none does.
  const std::string& problem() const;

 private:
  LineFile trajectory_, states_;
};

}  // namespace revisit_slam
