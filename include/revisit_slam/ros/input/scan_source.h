// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "revisit_slam/input/point_cloud.h"
#include "revisit_slam/priors/gnss_config.h"
#include "revisit_slam/priors/priors_config.h"
#include "revisit_slam/ros/input/motion_reader.h"
#include "revisit_slam/ros/input/point_message.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// Why there is no scan.
struct UnreadableScan {
  std::string reason;
};
/// Likewise of a message that measures motion.
struct UnreadableMotion {
  const char* sensor;  ///< its name in MotionPriors or GnssTrack
  std::string reason;
};
/// A recorded scan, a message of a bag or the cloud of a dataset, or a message that measures
/// motion.
using ScanMessage =
    std::variant<RawMessage, PointCloud, UnreadableScan, MotionMessage, UnreadableMotion>;

/// Recorded scans in order, of a topic in bags, with what measures motion, or of a dataset.
class ScanSource {
 public:
  virtual ~ScanSource() = default;

  virtual std::string description() const = 0;
  /// Of the scans.
  virtual std::size_t size() = 0;
  /// How many sensors the scans are of.
  virtual std::size_t sensors() const { return 1; }
  /// The frame_id of the scans of one.
  virtual std::string sensorFrame(std::size_t sensor = 0) = 0;
  /// Whether it knows where sensors are on the robot.
  virtual bool hasTransforms() const = 0;
  virtual std::optional<Pose> findExtrinsics(const std::string& base_frame,
                                             const std::string& sensor_frame) const = 0;
  /// What of it cannot be used, beside scans; empty where nothing is.
  virtual std::string notice() const { return ""; }
  /// Hands all over until `consume` returns false. What is damaged is no reason to end.
  virtual void forEach(const std::function<bool(const ScanMessage&)>& consume) = 0;
};

/// An empty topic stands for the only topic with scans; several are between spaces.
/// @throws BagError
std::unique_ptr<ScanSource> openBags(const std::vector<std::string>& paths,
                                     const std::string& topic, const PriorsConfig& priors = {},
                                     const GnssConfig& gnss = {});

/// @throws DatasetError naming what is missing.
std::unique_ptr<ScanSource> openDatasetSource(const std::string& name, const std::string& folder);

}  // namespace revisit_slam
