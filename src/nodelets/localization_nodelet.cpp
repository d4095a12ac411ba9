// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/localization_nodelet.h"

#include <pluginlib/class_list_macros.hpp>

PLUGINLIB_EXPORT_CLASS(revisit_slam::LocalizationNodelet, nodelet::Nodelet)
