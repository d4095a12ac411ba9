// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/map_display.h"

#include <algorithm>
#include <boost/make_shared.hpp>

#include "revisit_slam/ros/messages/coloured_cloud.h"
#include "revisit_slam/ros/messages/density_message.h"
#include "revisit_slam/ros/messages/display.h"
#include "revisit_slam/ros/messages/loop_markers.h"
#include "revisit_slam/ros/messages/map_markers.h"
#include "revisit_slam/slam/map_correction.h"
#include "revisit_slam/types/session_groups.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kSearches = 20;  // the newest, which are shown

/// What placing a submap takes.
Submap keyposeOf(const Submap& submap) {
  Submap keypose;
  keypose.id = submap.id;
  keypose.local_map = submap.local_map;
  keypose.first_scan = submap.first_scan;
  keypose.T_odom_submap = submap.T_odom_submap;
  return keypose;
}

bool wanted(const ros::Publisher& publisher) {
  return publisher.getNumSubscribers() > 0;
}

/// With the points alone that reach farthest along x and y, which its outline is drawn around.
LocalMapPtr outermost(const LocalMap& map) {
  auto outline = std::make_shared<LocalMap>();
  outline->id = map.id;
  outline->submaps = {std::make_shared<const Submap>(keyposeOf(*map.submaps.front()))};
  for (int axis = 0; axis < 2; ++axis) {
    const auto is_less = [axis](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
      return a[axis] < b[axis];
    };
    const auto [least, most] = std::minmax_element(map.points.begin(), map.points.end(), is_less);
    if (least == map.points.end()) continue;
    outline->points.push_back(*least);
    outline->points.push_back(*most);
  }
  return outline;
}

}  // namespace

MapDisplay::MapDisplay(ros::NodeHandle& node, const SlamConfig& config,
                       std::function<void()> on_subscriber)
    : frame_(config.frames.map), max_points_(config.live.max_cloud_points) {
  const bool latch = true;
  const ros::SubscriberStatusCallback connected =
      [on_subscriber](const ros::SingleSubscriberPublisher&) { on_subscriber(); };
  const ros::SubscriberStatusCallback none;
  const ros::VoidConstPtr untracked;
  using Cloud = sensor_msgs::PointCloud2;
  using Markers = visualization_msgs::MarkerArray;
  local_maps_ = node.advertise<Cloud>("local_maps", 1, connected, none, untracked, latch);
  submap_points_ = node.advertise<Cloud>("submaps", 1, connected, none, untracked, latch);
  outlines_ = node.advertise<Markers>("map_outlines", 1, connected, none, untracked, latch);
  keyposes_ = node.advertise<Markers>("keyposes", 1, connected, none, untracked, latch);
  density_ =
      node.advertise<sensor_msgs::Image>("density_image", 1, connected, none, untracked, latch);
  candidates_ = node.advertise<Markers>("loop_candidates", 1, connected, none, untracked, latch);
}

void MapDisplay::startAnew(SessionId session, const KnownMapPtr& prior) {
  session_ = session;
  submaps_.clear();
  library_.reset();
  maps_.clear();
  searches_.clear();
  view_.reset();
  prior_submaps_.clear();
  prior_maps_.clear();
  correction_.reset();
  if (prior) {
    correction_ = std::make_shared<const MapCorrection>(correctionOf({prior.get()}));
    for (const LocalMapPtr& map : prior->maps) {
      prior_maps_[map->id] = map;
      for (const SubmapPtr& submap : map->submaps) prior_submaps_[submap->id] = submap;
    }
  }
  draw();
}

void MapDisplay::add(const LoopSearchResult& search) {
  if (search.map->id.session != session_) return;
  if (search.origin == LoopOrigin::appearance) maps_.push_back(outermost(*search.map));
  if (search.view) view_ = search.view;
  searches_.push_back(search);
  if (searches_.size() > kSearches) searches_.pop_front();
}

/// Whether it is known where the session lies in the map.
bool MapDisplay::isPlaced() const {
  return prior_maps_.empty() || correction_->places(session_);
}

Pose MapDisplay::placeOf(const Submap& submap) const {
  if (!correction_) return submap.T_odom_submap;
  const auto begin = correction_->begin.find(submap.id.session);
  const std::size_t end = correction_->T_map_scan.size();
  const std::size_t scan =
      begin == correction_->begin.end() ? end : begin->second + submap.first_scan.value;
  return scan < end ? correction_->T_map_scan[scan]
                    : correction_->T_map_odom * submap.T_odom_submap;
}

void MapDisplay::draw() const {
  drawClouds();
  drawMarkers();
  if (wanted(density_) && view_) {
    sensor_msgs::Image image = toDensityMessage(*view_);
    image.header.stamp = ros::Time::now();
    image.header.frame_id = frame_;
    density_.publish(boost::make_shared<const sensor_msgs::Image>(std::move(image)));
  }
}

void MapDisplay::drawClouds() const {
  if (wanted(local_maps_))
    local_maps_.publish(
        drawn([](const Submap& submap) { return colourOf(submap.local_map.value); }));
  if (wanted(submap_points_))
    submap_points_.publish(drawn([](const Submap& submap) { return colourOf(submap.id.value); }));
}

sensor_msgs::PointCloud2 MapDisplay::drawn(
    const std::function<std_msgs::ColorRGBA(const Submap&)>& colour) const {
  const std::vector<SubmapPtr> shown_submaps = shown(submaps_);
  std::size_t total = 0;
  for (const SubmapPtr& submap : shown_submaps) total += library_->points(submap->id);
  ColouredCloud cloud(frame_, total, max_points_);
  for (const SubmapPtr& submap : shown_submaps)
    cloud.add({&library_->whole(submap->id)->points, placeOf(*submap), colour(*submap)});
  return cloud.take();
}

void MapDisplay::drawMarkers() const {
  if (wanted(outlines_)) {
    std::vector<Pose> T_map_local;
    for (const LocalMapPtr& map : shown(maps_)) T_map_local.push_back(placeOf(*map));
    outlines_.publish(toOutlines(shown(maps_), T_map_local, frame_));
  }
  if (wanted(keyposes_)) {
    std::vector<Pose> T_map_submap;
    for (const SubmapPtr& submap : shown(submaps_)) T_map_submap.push_back(placeOf(*submap));
    keyposes_.publish(toKeyposes(shown(submaps_), T_map_submap, frame_));
  }
  if (wanted(candidates_)) drawCandidates();
}

void MapDisplay::drawCandidates() const {
  candidates_.publish(toLoopCandidates(
      {searches_.begin(), searches_.end()},
      [this](LocalMapId id) {
        return placeOf(id.session == session_ ? *maps_.at(id.value) : *prior_maps_.at(id));
      },
      [this](SubmapId id) {
        return placeOf(id.session == session_ ? *submaps_.at(id.value) : *prior_submaps_.at(id));
      },
      frame_));
}

}  // namespace revisit_slam
