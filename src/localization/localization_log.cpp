// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/localization_log.h"

#include <cmath>
#include <sstream>

#include "revisit_slam/io/trajectory.h"

namespace revisit_slam {
namespace {

constexpr const char* kHeader =
    "stamp,scan,state,since_fix_m,attempted,target,target_session,overlap,coherence,"
    "sigma_x,sigma_y,sigma_z,reason\n";

std::string lineOf(const Localization& now) {
  std::ostringstream line;
  line << stampText(now.stamp) << "," << now.scan.value << "," << toString(now.state) << ","
       << now.since_fix << "," << now.attempted << ",";
  if (now.target)
    line << now.target->value << "," << now.target->session.value;
  else
    line << ",";
  line << "," << now.overlap << "," << now.coherence;
  for (int axis = 0; axis < 3; ++axis) line << "," << std::sqrt(now.covariance(axis, axis));
  line << "," << now.reason << "\n";
  return line.str();
}

}  // namespace

LocalizationLog::LocalizationLog(const std::string& folder)
    : trajectory_(folder + "/localized.tum"), states_(folder + "/localization.csv", kHeader) {}

void LocalizationLog::add(const Localization& now) {
  states_.add(lineOf(now));
  if (now.state != LocalizationState::localized && now.state != LocalizationState::lost) return;
  std::ostringstream pose;
  writeTumLine(pose, {now.stamp, now.T_map_base});
  trajectory_.add(pose.str());
}

void LocalizationLog::flush() {
  for (LineFile* lines : {&trajectory_, &states_}) lines->flush();
}

const std::string& LocalizationLog::problem() const {
  return states_.problem().empty() ? trajectory_.problem() : states_.problem();
}

}  // namespace revisit_slam
