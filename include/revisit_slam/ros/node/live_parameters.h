// SPDX-License-Identifier: MIT
#pragma once

#include <dynamic_reconfigure/server.h>

#include <functional>
#include <string>
#include <vector>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// The values of a dynamic_reconfigure configuration as text.
std::vector<NamedText> textsOf(const dynamic_reconfigure::Config& values);

/// Puts parameters of those names into a dynamic_reconfigure configuration.
void fill(const std::vector<Parameter>& parameters, dynamic_reconfigure::Config& values);

/// Some parameters of a group that may change while the nodelet runs: those that a cfg/*.cfg file
/// names. They begin with the values of the configuration, wherever those are from: the server
/// would take its own defaults for what a preset says, or a number that is written as text. What
/// cannot be used, such as a NaN, is answered with the values in force.
template <typename LiveConfig, typename Config>
class LiveParameters {
 public:
  /// `group`: namespace of the parameters below `node`. `on_change` gets all values of the group,
  /// at once too.
  LiveParameters(const ros::NodeHandle& node, const std::string& group, const Config& config,
                 std::function<void(const Config&)> on_change)
      : config_(config),
        on_change_(std::move(on_change)),
        server_(withValues(ros::NodeHandle(node, group), config_)) {
    server_.setCallback([this](LiveConfig& values, uint32_t) { change(values); });
  }

 private:
  static ros::NodeHandle withValues(const ros::NodeHandle& node, Config& config) {
    LiveConfig values = LiveConfig::__getDefault__();
    dynamic_reconfigure::Config message;
    values.__toMessage__(message);
    fill(parametersOf(config), message);
    values.__fromMessage__(message);
    values.__toServer__(node);
    return node;
  }

  void change(LiveConfig& values) {
    dynamic_reconfigure::Config message;
    values.__toMessage__(message);
    Config wanted = config_;
    try {
      assign(parametersOf(wanted), textsOf(message));
      config_ = wanted;
      on_change_(config_);
    } catch (const std::exception& error) {
      ROS_ERROR("not changed: %s", error.what());
    }
    fill(parametersOf(config_), message);
    values.__fromMessage__(message);
  }

  Config config_;
  const std::function<void(const Config&)> on_change_;
  dynamic_reconfigure::Server<LiveConfig> server_;
};

}  // namespace revisit_slam
