// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/scan_source.h"

#include <boost/make_shared.hpp>

#include "revisit_slam/datasets/open_dataset.h"
#include "revisit_slam/priors/gnss_track.h"
#include "revisit_slam/priors/motion_priors.h"
#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/util/number_list.h"

namespace revisit_slam {
namespace {

MotionMessage motionOf(const rosbag::MessageInstance& instance) {
  if (const auto odometry = instance.instantiate<nav_msgs::Odometry>())
    return nav_msgs::Odometry::ConstPtr(odometry);
  if (const auto imu = instance.instantiate<sensor_msgs::Imu>())
    return sensor_msgs::Imu::ConstPtr(imu);
  if (const auto position = instance.instantiate<sensor_msgs::NavSatFix>())
    return sensor_msgs::NavSatFix::ConstPtr(position);
  return boost::make_shared<const tf2_msgs::TFMessage>(transformsOf(rawMessageOf(instance)));
}

/// Null: it is a scan.
const char* sensorOf(const rosbag::MessageInstance& instance) {
  if (instance.isType<sensor_msgs::Imu>()) return MotionPriors::kGyro;
  if (instance.isType<sensor_msgs::NavSatFix>()) return GnssTrack::kSensor;
  if (instance.isType<nav_msgs::Odometry>() || instance.isType<tf2_msgs::TFMessage>())
    return MotionPriors::kOdometry;
  return nullptr;
}

ScanMessage messageOf(const rosbag::MessageInstance& instance) {
  const char* sensor = sensorOf(instance);
  try {
    return sensor != nullptr ? ScanMessage(motionOf(instance)) : rawMessageOf(instance);
  } catch (const std::exception& error) {  // of this message, or of the piece that it is in
    const std::string reason = std::string("the bag is damaged: ") + error.what();
    if (sensor == nullptr) return UnreadableScan{reason};
    return UnreadableMotion{sensor, reason};
  }
}

/// One that is empty where none is named.
std::vector<std::string> topicsOf(const std::string& text) {
  std::vector<std::string> topics = wordsOf(text);
  if (topics.empty()) topics.emplace_back();
  return topics;
}

class BagSource : public ScanSource {
 public:
  BagSource(const std::vector<std::string>& paths, const std::string& topic,
            const PriorsConfig& priors, const GnssConfig& gnss)
      : bags_(paths, topicsOf(topic)), messages_(bags_.messagesWith(priors, gnss)) {}

  std::string description() const override { return "topic " + bags_.topic(); }
  std::size_t size() override { return bags_.size(); }
  bool hasTransforms() const override { return bags_.hasTransforms(); }

  std::size_t sensors() const override { return bags_.sensors(); }
  std::string sensorFrame(std::size_t sensor) override { return bags_.sensorFrame(sensor); }

  std::string notice() const override {
    const std::size_t damaged = bags_.damagedTransforms();
    return damaged == 0 ? "" : std::to_string(damaged) + " messages with transforms are damaged";
  }

  std::optional<Pose> findExtrinsics(const std::string& base_frame,
                                     const std::string& sensor_frame) const override {
    return bags_.findExtrinsics(base_frame, sensor_frame);
  }

  void forEach(const std::function<bool(const ScanMessage&)>& consume) override {
    for (const rosbag::MessageInstance& instance : *messages_)
      if (!consume(numbered(messageOf(instance), instance.getTopic()))) break;
  }

 private:
  /// With the number of its sensor.
  ScanMessage numbered(ScanMessage message, const std::string& topic) const {
    if (auto* raw = std::get_if<RawMessage>(&message)) raw->sensor = bags_.sensorOf(topic);
    return message;
  }

  BagScans bags_;
  std::unique_ptr<rosbag::View> messages_;
};

class DatasetSource : public ScanSource {
 public:
  DatasetSource(const std::string& name, const std::string& folder)
      : description_("dataset " + name + " in " + folder), scans_(openDataset(name, folder)) {}

  std::string description() const override { return description_; }
  std::size_t size() override { return scans_->size(); }
  std::string sensorFrame(std::size_t) override { return scans_->frame(); }
  bool hasTransforms() const override { return false; }
  std::optional<Pose> findExtrinsics(const std::string&, const std::string&) const override {
    return std::nullopt;
  }

  void forEach(const std::function<bool(const ScanMessage&)>& consume) override {
    for (std::size_t i = 0; i < scans_->size(); ++i)
      if (!consume(read(i))) break;
  }

 private:
  ScanMessage read(std::size_t index) const {
    try {
      return scans_->read(index);
    } catch (const DatasetError& error) {
      return UnreadableScan{error.what()};
    }
  }

  std::string description_;
  std::unique_ptr<DatasetScans> scans_;
};

}  // namespace

std::unique_ptr<ScanSource> openBags(const std::vector<std::string>& paths,
                                     const std::string& topic, const PriorsConfig& priors,
                                     const GnssConfig& gnss) {
  return std::make_unique<BagSource>(paths, topic, priors, gnss);
}

std::unique_ptr<ScanSource> openDatasetSource(const std::string& name, const std::string& folder) {
  return std::make_unique<DatasetSource>(name, folder);
}

}  // namespace revisit_slam
