// SPDX-License-Identifier: MIT
#include "mapped_drive.h"

#include <sensor_msgs/PointCloud2.h>

#include <stdexcept>

#include "revisit_slam/util/progress.h"
#include "revisit_slam/slam/information_stage.h"
#include "revisit_slam/slam/map_builder.h"
#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/ros/node/front_end.h"

namespace revisit_slam {
namespace {

Pose extrinsics(BagScans& bag, const std::string& base_frame) {
  for (const rosbag::MessageInstance& instance : bag.messages())
    if (const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>())
      if (const auto T_base_sensor = bag.findExtrinsics(base_frame, cloud->header.frame_id))
        return *T_base_sensor;
  throw BagError("the bag does not say where the sensor is on '" + base_frame + "'");
}

Pose poseAt(const PoseInterpolator& truth, Stamp stamp) {
  const PoseAnswer answer = truth.at(stamp);
  if (!answer)
    throw std::runtime_error("the truth does not cover the scan at " + stampText(stamp));
  return answer.T_world_base;
}

void append(Stretch& stretch, const Submap& submap, const Pose& T_map_submap,
            const PoseInterpolator& truth) {
  for (std::size_t i = 0; i < submap.stamps.size(); ++i) {
    stretch.T_map_scan.push_back(T_map_submap * submap.T_submap_scan[i]);
    stretch.T_world_scan.push_back(poseAt(truth, submap.stamps[i]));
  }
}

}  // namespace

MappedDrive mapDrive(const std::string& path, const std::string& topic, const SlamConfig& config,
                     bool quiet) {
  BagScans bag({path}, topic);
  FrontEnd front_end(config);
  front_end.setExtrinsics(extrinsics(bag, config.frames.base));
  InformationStage information(config.information);
  MapBuilder builder(config.mapping, config.occupancy);
  MappedDrive drive;
  const auto keep = [&](const MapUpdate& update) {
    if (update.local_map) drive.maps.push_back(update.local_map);
  };
  Progress progress("mapping", "scans", bag.size(), quiet);
  std::size_t done = 0;
  for (const rosbag::MessageInstance& instance : bag.messages()) {
    const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>();
    if (!cloud) continue;
    FrontEnd::Result result = front_end.process(*cloud);
    progress.update(++done);
    if (!result.scan) continue;
    const InformedScan informed =
        information.inform(std::make_shared<const RegisteredScan>(std::move(*result.scan)));
    keep(builder.insert(*informed.scan));
    drive.nodes.push_back(nodeOf(informed));
  }
  keep(builder.closeAll());
  progress.finish();
  return drive;
}

Stretch stretchOf(const Submap& submap, const PoseInterpolator& truth) {
  Stretch stretch;
  append(stretch, submap, Pose::identity(), truth);
  return stretch;
}

Stretch stretchOf(const LocalMap& map, const PoseInterpolator& truth) {
  Stretch stretch;
  for (const SubmapPtr& submap : map.submaps)
    append(stretch, *submap, map.T_odom_local().inverse() * submap->T_odom_submap, truth);
  return stretch;
}

}  // namespace revisit_slam
