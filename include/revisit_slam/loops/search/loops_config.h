// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/loops/acceptance/loop_closer_config.h"
#include "revisit_slam/loops/acceptance/session_joining.h"
#include "revisit_slam/loops/recognition/place_recognition_config.h"

namespace revisit_slam {

/// Closing loops by appearance (paper Sec. III-C).
struct LoopsConfig {
  bool enabled = true;
  PlaceRecognitionConfig recognition;
  LoopCloserConfig closer;
  JoiningConfig joining;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("enabled", enabled,
      "true: loops are closed; false: no loop is closed, and the map is that of the odometry");
    v.group("recognition", recognition);
    closer.visit(v);
    v.group("joining", joining);
  }
};

}  // namespace revisit_slam
