// SPDX-License-Identifier: MIT
#include <iostream>

#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/session/session_summary.h"
#include "steps.h"

namespace revisit_slam {

void summariseSession(const SummariseOptions& options) {
  std::vector<std::string> notices;
  const SessionSummary summary = summarise(options.session, options.name, notices);
  for (const std::string& notice : notices) std::cerr << "fleet_step: " << notice << "\n";
  writeWholeText(options.out, encodeSummary(summary));
}

}  // namespace revisit_slam
