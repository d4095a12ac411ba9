// SPDX-License-Identifier: MIT
#include "localized_drive.h"

#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace revisit_slam {

LocalizedDrive::LocalizedDrive(const SlamConfig& config, const RunFolder& folder, Say say)
    : say_(std::move(say)),
      stage_(config, notices_),
      trajectory_(folder.file("localized.tum")),
      states_(folder.file("localization.csv"),
              "stamp,scan,state,since_fix_m,attempted,target,target_session,overlap,coherence,"
              "sigma_x,sigma_y,"
              "sigma_z,reason\n") {
  for (const std::string& notice : notices_) say_(notice);
}

void LocalizedDrive::add(const InformedScan& informed) {
  const Localization now = stage_.add(informed);
  saySo(now);
  std::ostringstream state;
  state << stampText(now.stamp) << "," << now.scan.value << "," << toString(now.state) << ","
        << now.since_fix << "," << now.attempted << ",";
  if (now.target)
    state << now.target->value << "," << now.target->session.value;
  else
    state << ",";
  state << "," << now.overlap << "," << now.coherence;
  for (int axis = 0; axis < 3; ++axis) state << "," << std::sqrt(now.covariance(axis, axis));
  state << "," << now.reason << "\n";
  states_.add(state.str());
  if (now.state != LocalizationState::localized && now.state != LocalizationState::lost) return;
  std::ostringstream line;
  writeTumLine(line, {now.stamp, now.T_map_base});
  trajectory_.add(line.str());
}

void LocalizedDrive::saySo(const Localization& now) {
  if (now.state == said_) return;
  said_ = now.state;
  say_("scan " + std::to_string(now.scan.value) + ": " + toString(now.state) +
       (now.reason.empty() ? "" : " (" + now.reason + ")"));
}

void LocalizedDrive::finish() {
  for (LineFile* lines : {&trajectory_, &states_}) lines->flush();
}

}  // namespace revisit_slam
