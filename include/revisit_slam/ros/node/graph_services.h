// SPDX-License-Identifier: MIT
#pragma once

#include <revisit_slam/DisableLoop.h>
#include <revisit_slam/SaveMap.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>

#include "revisit_slam/slam/graph_session.h"

namespace revisit_slam {

/// The services of the back-end. They wait for its worker: in threads of their own, so that no
/// other callback waits too.
class GraphServices {
 public:
  using Work = std::function<void(GraphSession*)>;

  /// `do_in_worker` returns when the worker has done the work, with the session that runs (null:
  /// none yet); it throws what the work throws. `close_maps`: publishes CloseMaps.
  GraphServices(const ros::NodeHandle& private_node, const LiveConfig& live,
                std::function<void(const Work&)> do_in_worker, const ros::Publisher& close_maps);
  /// Returns when no service waits any more; the worker must still run.
  void stop();

  /// The worker has finished what this request asked for. `problem`: empty, or why it could not.
  /// `folder`: where the files are; empty: there are none.
  void answer(std::uint32_t request, const std::string& problem, const std::string& folder);

 private:
  bool save(SaveMap::Request& request, SaveMap::Response& response);
  bool disable(DisableLoop::Request& request, DisableLoop::Response& response);
  bool finish(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  const LiveConfig live_;
  const std::function<void(const Work&)> do_in_worker_;
  const ros::Publisher close_maps_;
  std::atomic<bool> ending_{false};

  std::mutex mutex_;  // guards the next four
  std::condition_variable changed_;
  std::uint32_t requests_ = 0, answered_ = 0;
  std::string problem_, folder_;  // of the last answer

  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{2, &queue_};
  ros::ServiceServer save_service_, finish_service_, disable_service_;
};

}  // namespace revisit_slam
