// SPDX-License-Identifier: MIT
#pragma once

#include <tf2_ros/transform_listener.h>

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/util/frame_name.h"

namespace revisit_slam {

/// Where sensors are on the robot, by TF. For one thread, but for fault().
class SensorPlacement {
 public:
  /// `base_frame` empty: the frame of the first scan. `patience`: seconds to wait for the transform
  /// of a frame that is seen for the first time.
  SensorPlacement(const std::string& base_frame, double patience)
      : base_frame_(base_frame), given_base_frame_(base_frame), patience_(patience) {}

  /// The next scan is the first again.
  void restart();

  /// T_base_sensor, or nothing where the two frames are not connected. Follows a transform that
  /// changes, and says so. Waits by wall clock, as simulated time may not run, until `stopping`
  /// returns true.
  std::optional<Pose> find(const std::string& frame, const std::function<bool()>& stopping);

  /// Whether find() would find it now.
  bool knows(const std::string& sensor_frame) const {
    return lookUp(withoutLeadingSlash(sensor_frame)).has_value();
  }

  /// The frame in which TF places the base, unless it is `own_parent`; empty: none.
  std::string parentOfBase(const std::string& own_parent) const;

  /// That of the poses; empty before the first scan where it was given empty.
  const std::string& baseFrame() const { return base_frame_; }

  /// Why the last scans could not be placed, with what to do; empty where they could. Thread-safe.
  std::string fault() const;

 private:
  std::optional<Pose> lookUp(const std::string& sensor_frame) const;
  void noteMissing(const std::string& sensor_frame);
  void noteFound(const std::string& sensor_frame);
  std::optional<Pose> waitFor(const std::string& sensor_frame,
                              const std::function<bool()>& stopping);

  std::string base_frame_;
  const std::string given_base_frame_;
  const double patience_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_{buffer_};
  struct Missing {
    std::string base_frame, sensor_frame;
  };
  mutable std::mutex mutex_;  // guards the next one
  std::optional<Missing> missing_;
  std::map<std::string, std::optional<Pose>> placed_;  // by frame; nothing: waited in vain
};

}  // namespace revisit_slam
