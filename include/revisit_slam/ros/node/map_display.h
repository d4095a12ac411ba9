// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/ColorRGBA.h>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "revisit_slam/loops/search/loop_search_result.h"
#include "revisit_slam/mapping/submap_library.h"
#include "revisit_slam/session/known_map.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/map_correction.h"

namespace revisit_slam {

/// Maps, and the search for loops, for rviz: where the newest correction has them. What nobody
/// listens to is not built. Only one thread may use it.
class MapDisplay {
 public:
  /// `on_subscriber` is called in a thread of the node when somebody begins to listen.
  MapDisplay(ros::NodeHandle& node, const SlamConfig& config, std::function<void()> on_subscriber);

  /// `prior`: the map that the session goes on from, null: none. It is not shown, but what looks
  /// like it is.
  void startAnew(SessionId session, const KnownMapPtr& prior);
  void add(const SubmapPtr& submap, const std::shared_ptr<SubmapLibrary>& library) {
    if (submap->id.session != session_) return;
    library_ = library;
    submaps_.push_back(library->light(submap->id));
  }
  void add(const LoopSearchResult& search);
  /// One of another session places nothing.
  void place(const MapCorrectionPtr& correction) {
    if (correction->session == session_ && correction->version > 0) correction_ = correction;
  }
  void draw() const;

 private:
  bool isPlaced() const;
  template <typename Map>
  std::vector<Map> shown(const std::vector<Map>& maps) const {
    return isPlaced() ? maps : std::vector<Map>{};
  }
  Pose placeOf(const Submap& submap) const;
  Pose placeOf(const LocalMap& map) const { return placeOf(*map.submaps.front()); }
  void drawClouds() const;
  sensor_msgs::PointCloud2 drawn(
      const std::function<std_msgs::ColorRGBA(const Submap&)>& colour) const;
  void drawMarkers() const;
  void drawCandidates() const;

  std::string frame_;
  int max_points_;
  ros::Publisher local_maps_, submap_points_, outlines_, keyposes_, density_, candidates_;

  SessionId session_;
  std::shared_ptr<SubmapLibrary> library_;  // of the points; null before the first submap
  std::vector<SubmapPtr> submaps_;          // by number, without points
  std::vector<LocalMapPtr> maps_;           // by number, of their points the outermost
  std::map<SubmapId, SubmapPtr> prior_submaps_;
  std::map<LocalMapId, LocalMapPtr> prior_maps_;
  std::deque<LoopSearchResult> searches_;
  std::shared_ptr<const PlaceView> view_;  // the newest
  MapCorrectionPtr correction_;
};

}  // namespace revisit_slam
