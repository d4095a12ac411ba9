// SPDX-License-Identifier: MIT
#include "revisit_slam/types/loop_edge.h"

namespace revisit_slam {

const char* toString(LoopState state) {
  switch (state) {
    case LoopState::active:
      return "active";
    case LoopState::rejected:
      return "rejected";
    case LoopState::disabled:
      return "disabled";
  }
  return "unknown";
}

const char* toString(LoopOrigin origin) {
  switch (origin) {
    case LoopOrigin::appearance:
      return "appearance";
    case LoopOrigin::retroactive:
      return "retroactive";
  }
  return "unknown";
}

}  // namespace revisit_slam
