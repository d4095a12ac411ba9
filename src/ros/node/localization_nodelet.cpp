// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/localization_nodelet.h"

#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "revisit_slam/ros/messages/coloured_cloud.h"
#include "revisit_slam/ros/messages/display.h"
#include "revisit_slam/ros/messages/localization_messages.h"
#include "revisit_slam/ros/messages/scan_messages.h"
#include "revisit_slam/ros/node/stage_topics.h"
#include "revisit_slam/slam/session_targets.h"
#include "revisit_slam/slam/thinned_scan.h"

namespace revisit_slam {

LocalizationNodelet::~LocalizationNodelet() {
  stopDiagnostics();
  transform_timer_.stop();
  scan_subscriber_.shutdown();
  start_subscriber_.shutdown();
  if (loader_) loader_->stop();
  if (lane_) {
    lane_->drain();
    lane_->stop();
  }
  map_publisher_.shutdown();
  endLog();
}

/// The next scan begins another one.
void LocalizationNodelet::endLog() {
  try {
    if (log_) log_->flush();
  } catch (const std::runtime_error& error) {
    NODELET_ERROR("%s", error.what());
  }
  log_.reset();
}

void LocalizationNodelet::start() {
  requireWritable(config_.live);
  try {
    stage_ = readMap(config_.localization.map, config_.localization.start);
  } catch (const std::runtime_error& error) {
    throw ParameterError("localization/map = '" + config_.localization.map + "': " + error.what());
  }
  broadcaster_ = std::make_unique<MapBroadcaster>(config_.frames, config_.live);
  datum_ = std::make_unique<DatumTopic>(getNodeHandle());
  lane_ = makeLane("localization", config_.background.niceness);
  ros::NodeHandle& node = getNodeHandle();
  transform_timer_ =
      node.createWallTimer(ros::WallDuration(1.0 / config_.live.transform_rate),
                           [this](const auto&) { guarded([this] { broadcaster_->broadcast(); }); });
  // In the lane, where the map is drawn: not before it has a publisher.
  lane_->post([&] {
    advertise(node);
    tellWhereOnEarth();
    drawMapIfWanted();
  });
  lane_->drain();
  subscribe(node);
  loader_ = std::make_unique<MapLoader>(
      getPrivateNodeHandle(), config_.live,
      [this](const std::string& folder, LoadMap::Response& response) { load(folder, response); });
}

std::unique_ptr<LocalizationStage> LocalizationNodelet::readMap(const std::string& folder,
                                                                const std::string& start) const {
  SlamConfig config = config_;
  config.localization.start = start;
  config.localization.map = folder;
  std::vector<std::string> notices;
  auto stage = std::make_unique<LocalizationStage>(config, notices);
  for (const std::string& notice : notices) NODELET_WARN("%s", notice.c_str());
  NODELET_INFO("localizing in '%s': %zu submaps, %zu places", folder.c_str(),
               stage->map().submaps.size(), stage->map().places.size());
  return stage;
}

/// In the thread of the service. It answers when the map is in use.
void LocalizationNodelet::load(const std::string& folder, LoadMap::Response& response) {
  std::unique_ptr<LocalizationStage> stage =
      readMap(folder, "");  // the start was of the first scan
  response.submaps = static_cast<std::uint32_t>(stage->map().submaps.size());
  response.places = static_cast<std::uint32_t>(stage->map().places.size());
  const auto task = std::make_shared<std::packaged_task<void()>>([&] { change(std::move(stage)); });
  lane_->post([task] { (*task)(); });
  task->get_future().get();
  response.message = "searching in it";
}

void LocalizationNodelet::change(std::unique_ptr<LocalizationStage> stage) {
  stage_ = std::move(stage);
  endLog();
  broadcaster_->forget();
  tellWhereOnEarth();
  Localization anew;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_ = anew;
  }
  status_publisher_.publish(toStatus(anew, config_.frames.map));
  cloud_.reset();
  guarded([this] { drawMapIfWanted(); });  // the map is in use, whether it can be drawn or not
}

void LocalizationNodelet::tellWhereOnEarth() {
  broadcaster_->tieToEarth(stage_->map().georeference);
  datum_->publish(stage_->map().georeference);
}

void LocalizationNodelet::advertise(ros::NodeHandle& node) {
  const bool latch = true;
  const ros::SubscriberStatusCallback connected = [this](const ros::SingleSubscriberPublisher&) {
    lane_->post([this] { drawMap(); });
  };
  const ros::SubscriberStatusCallback none;
  using Cloud = sensor_msgs::PointCloud2;
  status_publisher_ = node.advertise<LocalizationStatus>("localization", 10, latch);
  pose_publisher_ = node.advertise<geometry_msgs::PoseWithCovarianceStamped>("localized_pose", 100);
  target_publisher_ = node.advertise<Cloud>("matched_submap", 1, latch);
  text_publisher_ = node.advertise<visualization_msgs::Marker>("localization_text", 1, latch);
  map_publisher_ =
      node.advertise<Cloud>("prior_map", 1, connected, none, ros::VoidConstPtr(), latch);
}

void LocalizationNodelet::subscribe(ros::NodeHandle& node) {
  const uint32_t depth = 0;  // no limit: none may be lost
  scan_subscriber_ = node.subscribe<InformedScan>(
      "informed_scan", depth, [this](const boost::shared_ptr<const InformedScan>& informed) {
        if (lane_->waiting() <= mostWaiting())
          lane_->post([this, informed] { add(*informed); });
        else
          postThinned(*informed);
      });
  using Drawn = geometry_msgs::PoseWithCovarianceStamped;
  start_subscriber_ = node.subscribe<Drawn>(
      "initialpose", 10,
      [this](const Drawn::ConstPtr& drawn) { lane_->post([this, drawn] { startAt(*drawn); }); });
}

/// The way goes on, whatever waits; memory does not grow without limit.
void LocalizationNodelet::postThinned(InformedScan informed) {
  informed.scan = withoutPoints(*informed.scan);
  ++thinned_scans_;
  lane_->post([this, informed] { add(informed); });
}

std::size_t LocalizationNodelet::mostWaiting() const {
  return static_cast<std::size_t>(config_.mapping.max_waiting);
}

void LocalizationNodelet::add(const InformedScan& informed) {
  const Localization now = stage_->add(informed);
  if (now.state != LocalizationState::searching)
    broadcaster_->place(*informed.scan, now.T_map_odom);
  else if (last_.state != now.state)
    broadcaster_->forget();  // what spoke for the place did not hold
  publish(now);
  write(now);
}

/// Each session of the odometry has a folder, made anew where it is removed. What cannot be written
/// waits for the next scan.
void LocalizationNodelet::write(const Localization& now) {
  if (config_.live.folder.empty()) return;
  if (!log_ || logged_ != now.scan.session) {
    endLog();
    logged_ = now.scan.session;
    log_folder_ = liveTargets(config_.live, "")(logged_, now.stamp).folder;
    log_.emplace(log_folder_);
  }
  std::error_code ignored;  // the log waits
  std::filesystem::create_directories(log_folder_, ignored);
  log_->add(now);
  const std::lock_guard<std::mutex> lock(mutex_);
  log_problem_ = log_->problem();
}

void LocalizationNodelet::publish(const Localization& now) {
  LocalizationState before;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    before = std::exchange(last_, now).state;
  }
  const std::string& frame = config_.frames.map;
  if (now.state != before)
    NODELET_INFO("%s%s%s", toString(now.state), now.reason.empty() ? "" : ": ", now.reason.c_str());
  if (now.attempted || now.state != before) status_publisher_.publish(toStatus(now, frame));
  if (now.state == LocalizationState::localized || now.state == LocalizationState::lost)
    pose_publisher_.publish(toPoseWithCovariance(now, frame));
  if (now.attempted) drawTarget(now.target);
  drawState(now);
}

void LocalizationNodelet::startAt(const geometry_msgs::PoseWithCovarianceStamped& drawn) {
  if (const auto start = toStart(drawn, config_.frames.map, stage_->map())) {
    stage_->startAt(*start);
  } else {
    NODELET_WARN("a pose was drawn in the frame '%s', which is not '%s': it is left out",
                 drawn.header.frame_id.c_str(), config_.frames.map.c_str());
  }
}

/// Those in this process who listened before are not announced by roscpp 1.15 (Debian 11).
void LocalizationNodelet::drawMapIfWanted() {
  if (map_publisher_.getNumSubscribers() > 0) drawMap();
}

void LocalizationNodelet::drawMap() {
  std::map<SubmapId, Pose> T_map_submap;
  std::vector<SubmapPtr> submaps;
  for (const PlacedSubmap& placed : stage_->map().submaps) {
    submaps.push_back(placed.submap);
    T_map_submap[placed.submap->id] = placed.T_common_submap;
  }
  if (!cloud_) cloud_.emplace(submaps, *stage_->map().library, config_.live.max_cloud_points);
  map_publisher_.publish(cloud_->draw(config_.frames.map, [&](const Submap& submap) {
    return std::make_optional(T_map_submap.at(submap.id));
  }));
}

void LocalizationNodelet::drawTarget(const std::optional<SubmapId>& target) const {
  if (target_publisher_.getNumSubscribers() == 0) return;
  PlacedSubmap matched;
  std::vector<CloudPart> parts;
  for (const PlacedSubmap& placed : stage_->map().submaps) {
    if (placed.submap->id != target) continue;
    matched = stage_->map().whole(placed);
    parts.push_back({&matched.submap->points, matched.T_common_submap, colour(0.2, 0.8, 0.3)});
  }
  target_publisher_.publish(
      toColouredCloud(parts, config_.frames.map, config_.live.max_cloud_points));
}

/// Where nothing is known it stands where the map begins.
void LocalizationNodelet::drawState(const Localization& now) const {
  if (text_publisher_.getNumSubscribers() == 0) return;
  text_publisher_.publish(
      toStateText(now, stage_->map().T_map_scan.front().translation, config_.frames.map));
}

void LocalizationNodelet::diagnose(diagnostic_msgs::DiagnosticStatus& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  status.level = last_.state == LocalizationState::localized ? status.OK
                 : last_.state == LocalizationState::lost    ? status.ERROR
                                                             : status.WARN;
  status.message = toString(last_.state);
  if (!last_.reason.empty()) status.message += ": " + last_.reason;
  if (!log_problem_.empty()) {
    status.level = std::max<std::int8_t>(status.level, status.WARN);
    status.message += "; what is localized is not on disk, and is tried again: " + log_problem_;
  }
  addValue("travelled since the last fix (m)", std::to_string(last_.since_fix), status);
  addValue("overlap", std::to_string(last_.overlap), status);
  addValue("coherence", std::to_string(last_.coherence), status);
  if (last_.target) addValue("matched submap", std::to_string(last_.target->value), status);
  if (lane_->waiting() > mostWaiting()) {
    status.level = std::max<std::int8_t>(status.level, status.WARN);
    status.message += "; falling behind, " + std::to_string(lane_->waiting()) +
                      " scans wait: raise localization/interval";
  }
  addValue("scans waiting", std::to_string(lane_->waiting()), status);
  addValue("scans without their points", std::to_string(thinned_scans_), status);
}

}  // namespace revisit_slam
