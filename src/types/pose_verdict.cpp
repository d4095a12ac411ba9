// SPDX-License-Identifier: MIT
#include "revisit_slam/types/pose_verdict.h"

namespace revisit_slam {

const char* toString(PoseVerdict verdict) {
  switch (verdict) {
    case PoseVerdict::good:
      return "good";
    case PoseVerdict::weak:
      return "weak";
    case PoseVerdict::poor:
      return "poor";
    case PoseVerdict::lost:
      return "lost";
  }
  return "unknown";
}

}  // namespace revisit_slam
