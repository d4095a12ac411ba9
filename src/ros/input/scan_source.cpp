// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/scan_source.h"

#include "revisit_slam/datasets/open_dataset.h"
#include "revisit_slam/ros/input/bag_scans.h"

namespace revisit_slam {
namespace {

ScanMessage messageOf(const rosbag::MessageInstance& instance) {
  if (const auto odometry = instance.instantiate<nav_msgs::Odometry>())
    return MotionMessage(nav_msgs::Odometry::ConstPtr(odometry));
  if (const auto imu = instance.instantiate<sensor_msgs::Imu>())
    return MotionMessage(sensor_msgs::Imu::ConstPtr(imu));
  if (const auto transforms = instance.instantiate<tf2_msgs::TFMessage>())
    return MotionMessage(tf2_msgs::TFMessage::ConstPtr(transforms));
  if (const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>())
    return sensor_msgs::PointCloud2::ConstPtr(cloud);
  return topic_tools::ShapeShifter::ConstPtr(instance.instantiate<topic_tools::ShapeShifter>());
}

/// Every message with scans starts with a header.
std::string frameOf(const rosbag::MessageInstance& instance) {
  std::vector<std::uint8_t> bytes(instance.size());
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  instance.write(out);
  ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  std_msgs::Header header;
  ros::serialization::deserialize(in, header);
  return header.frame_id;
}

class BagSource : public ScanSource {
 public:
  BagSource(const std::vector<std::string>& paths, const std::string& topic,
            const PriorsConfig& priors)
      : bags_(paths, topic), messages_(bags_.messagesWith(priors)) {}

  std::string description() const override { return "topic " + bags_.topic(); }
  std::size_t size() override { return bags_.size(); }
  bool hasTransforms() const override { return bags_.hasTransforms(); }

  std::string sensorFrame() override {
    const auto first = bags_.messages().begin();
    return first == bags_.messages().end() ? "" : frameOf(*first);
  }

  std::optional<Pose> findExtrinsics(const std::string& base_frame,
                                     const std::string& sensor_frame) const override {
    return bags_.findExtrinsics(base_frame, sensor_frame);
  }

  std::string forEach(const std::function<bool(const ScanMessage&)>& consume) override {
    try {
      for (const rosbag::MessageInstance& instance : *messages_)
        if (!consume(messageOf(instance))) break;
    } catch (const rosbag::BagException& error) {
      return std::string("the bag is damaged: ") + error.what();
    }
    return "";
  }

 private:
  BagScans bags_;
  std::unique_ptr<rosbag::View> messages_;
};

class DatasetSource : public ScanSource {
 public:
  DatasetSource(const std::string& name, const std::string& folder)
      : description_("dataset " + name + " in " + folder), scans_(openDataset(name, folder)) {}

  std::string description() const override { return description_; }
  std::size_t size() override { return scans_->size(); }
  std::string sensorFrame() override { return scans_->frame(); }
  bool hasTransforms() const override { return false; }
  std::optional<Pose> findExtrinsics(const std::string&, const std::string&) const override {
    return std::nullopt;
  }

  std::string forEach(const std::function<bool(const ScanMessage&)>& consume) override {
    for (std::size_t i = 0; i < scans_->size(); ++i)
      if (!consume(read(i))) break;
    return "";
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
                                     const std::string& topic, const PriorsConfig& priors) {
  return std::make_unique<BagSource>(paths, topic, priors);
}

std::unique_ptr<ScanSource> openDatasetSource(const std::string& name, const std::string& folder) {
  return std::make_unique<DatasetSource>(name, folder);
}

}  // namespace revisit_slam
