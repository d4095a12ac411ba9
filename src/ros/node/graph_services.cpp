// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/graph_services.h"

#include <ros/console.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "revisit_slam/ros/node/stage_topics.h"
#include "revisit_slam/slam/save_root.h"

namespace revisit_slam {
namespace {

std::string secondsSince(const ros::WallTime& start) {
  char text[32];
  std::snprintf(text, sizeof(text), ", in %.1f s", (ros::WallTime::now() - start).toSec());
  return text;
}

std::string describeFinish(const std::string& folder) {
  if (!folder.empty()) return "finished: the map is in " + folder;
  return "finished; no file was written, as live/folder is empty: call back_end/save \"folder: "
         "'/tmp/map'\"";
}

void log(bool success, const std::string& message) {
  if (success)
    ROS_INFO("%s", message.c_str());
  else
    ROS_ERROR("%s", message.c_str());
}

}  // namespace

GraphServices::GraphServices(const ros::NodeHandle& private_node, const LiveConfig& live,
                             std::function<void(const Work&)> do_in_worker,
                             const ros::Publisher& close_maps)
    : live_(live), do_in_worker_(std::move(do_in_worker)), close_maps_(close_maps) {
  ros::NodeHandle node(private_node);
  node.setCallbackQueue(&queue_);
  save_service_ = node.advertiseService("save", &GraphServices::save, this);
  finish_service_ = node.advertiseService("finish", &GraphServices::finish, this);
  disable_service_ = node.advertiseService("disable_loop", &GraphServices::disable, this);
  spinner_.start();
}

void GraphServices::stop() {
  ending_ = true;
  spinner_.stop();
}

bool GraphServices::save(SaveMap::Request& request, SaveMap::Response& response) {
  const ros::WallTime start = ros::WallTime::now();
  try {
    requireBelowSaveRoot(live_, request.folder);
    bool has_maps = false;
    do_in_worker_([&](GraphSession* session) {
      if (!session) throw std::runtime_error("there is nothing to save yet");
      has_maps = !session->submaps().empty() || session->prior() != nullptr;
      response.path = session->save(request.folder);
      response.scans = static_cast<std::uint32_t>(session->graph().size());
      response.submaps = static_cast<std::uint32_t>(session->submaps().size());
      response.loops = static_cast<std::uint32_t>(activeLoops(session->graph()));
    });
    response.success = has_maps;
    response.message = response.success
                           ? "saved to " + response.path
                           : "only trajectory and graph are in " + response.path +
                                 ": no submap is closed yet; back_end/finish closes it";
    response.message += secondsSince(start);
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  log(response.success, response.message);
  return true;
}

bool GraphServices::disable(DisableLoop::Request& request, DisableLoop::Response& response) {
  try {
    do_in_worker_([&](GraphSession* session) {
      response.success = session && session->disable(LoopId{request.loop});
    });
    response.message = response.success ? "disabled" : "no loop of this id, or it is disabled";
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return true;
}

bool GraphServices::finish(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const ros::WallTime start = ros::WallTime::now();
  std::unique_lock<std::mutex> lock(mutex_);
  CloseMaps close;
  close.request = ++requests_;
  close_maps_.publish(boost::make_shared<const CloseMaps>(close));
  while (answered_ < close.request && !ending_) {
    if (close_maps_.getNumSubscribers() == 0) {
      response.message =
          "no map manager listens: load the nodelet revisit_slam/MapManager into "
          "the same nodelet manager, as slam.launch does";
      return true;
    }
    changed_.wait_for(lock, std::chrono::milliseconds(100));
  }
  response.success = answered_ >= close.request && problem_.empty();
  response.message = response.success ? describeFinish(folder_) + secondsSince(start) : problem_;
  log(response.success, response.message);
  return true;
}

void GraphServices::answer(std::uint32_t request, const std::string& problem,
                           const std::string& folder) {
  const std::lock_guard<std::mutex> lock(mutex_);
  answered_ = std::max(answered_, request);
  problem_ = problem;
  folder_ = folder;
  changed_.notify_all();
}

}  // namespace revisit_slam
