// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/types/informed_scan.h"

namespace revisit_slam {

/// Says in words when the verdict on the poses gets bad or good again.
class VerdictNotice {
 public:
  /// @return what there is to say of this scan; else empty.
  std::string take(const InformedScan& informed);

 private:
  PoseVerdict last_ = PoseVerdict::good;
};

}  // namespace revisit_slam
