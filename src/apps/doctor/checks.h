// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/ros/input/finding.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// What the doctor is asked to look at.
struct Patient {
  std::vector<std::string> bags;  ///< none: what is live
  std::string points;             ///< topic; empty: those of input/topics, or the only one
  std::string folder;             ///< where maps are to be written; empty: none
  std::string manager;            ///< nodelet manager that has to run; empty: any
  double seconds = 5.0;           ///< to listen
  std::size_t max_scans = 200;    ///< of a bag
  SlamConfig config;
};

/// Findings, and the command that maps what was found.
struct Diagnosis {
  std::vector<Finding> findings;
  std::string command;
};

/// Of the scans of each sensor; empty: the only one.
std::vector<std::string> topicsOf(const Patient& patient);

std::string betweenSpaces(const std::vector<std::string>& words);

Diagnosis checkBags(const Patient& patient);
/// Needs ros::init().
Diagnosis checkLive(const Patient& patient);
/// Whether a nodelet manager of this name takes nodelets, and those that do.
Finding checkManager(const std::string& wanted);
Finding checkFolder(const std::string& folder);

/// Where a sensor is on the robot. `connected`: frames that TF connects the sensor's with.
Finding aboutTransform(const std::string& base_frame, const std::string& sensor_frame,
                       bool is_known, const std::vector<std::string>& connected);

}  // namespace revisit_slam
