// SPDX-License-Identifier: MIT
#include "localized_drive.h"

#include <utility>

namespace revisit_slam {

LocalizedDrive::LocalizedDrive(const SlamConfig& config, const RunFolder& folder, Say say)
    : say_(std::move(say)), stage_(config, notices_), log_(folder.path()) {
  for (const std::string& notice : notices_) say_(notice);
}

void LocalizedDrive::add(const InformedScan& informed) {
  const Localization now = stage_.add(informed);
  saySo(now);
  log_.add(now);
}

void LocalizedDrive::saySo(const Localization& now) {
  if (now.state == said_) return;
  said_ = now.state;
  say_("scan " + std::to_string(now.scan.value) + ": " + toString(now.state) +
       (now.reason.empty() ? "" : " (" + now.reason + ")"));
}

void LocalizedDrive::finish() {
  log_.flush();
}

}  // namespace revisit_slam
