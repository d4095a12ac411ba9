// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>

#include "checks.h"
#include "revisit_slam/ros/messages/connected_frames.h"
#include "revisit_slam/slam/session_targets.h"
#include "revisit_slam/util/number_list.h"

namespace revisit_slam {

using Level = Finding::Level;

std::vector<std::string> topicsOf(const Patient& patient) {
  const std::vector<std::string> several = wordsOf(patient.config.input.topics);
  if (!patient.points.empty() || several.empty()) return {patient.points};
  return several;
}

std::string betweenSpaces(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

Finding aboutTransform(const std::string& base_frame, const std::string& sensor_frame,
                       bool is_known, const std::vector<std::string>& connected) {
  const std::string from = "'" + sensor_frame + "'", to = "'" + base_frame + "'";
  if (base_frame.empty() || base_frame == sensor_frame)
    return {Level::good, "transform", "none is needed: poses are those of the sensor, " + from, ""};
  if (is_known) return {Level::good, "transform", "from " + from + " to " + to, ""};
  const std::string others = listOf(connected);
  return {Level::fault, "transform", "there is none from " + from + " to " + to,
          (others.empty() ? "" : "start with base_frame:= one of " + others + "; or ") +
              "estimate the poses of the sensor itself: base_frame:=none live, --base-frame none "
              "offline; or broadcast the transform"};
}

Finding checkFolder(const std::string& folder) {
  constexpr double least = 2.0;  // GB; a kilometre takes some 100 MB
  LiveConfig live;
  live.folder = folder;
  try {
    requireWritable(live);
  } catch (const ParameterError& error) {
    const std::string text = error.what();
    const std::size_t split = text.find(": ");
    return {Level::fault, "folder", text.substr(0, split),
            split == std::string::npos ? "" : text.substr(split + 2)};
  }
  std::error_code ignored;
  const double free = 1e-9 * static_cast<double>(std::filesystem::space(folder, ignored).available);
  char text[64];
  std::snprintf(text, sizeof(text), "%.1f GB free in ", free);
  return {free < least ? Level::warning : Level::good, "folder", text + folder,
          free < least ? "make room, or choose another folder" : ""};
}

}  // namespace revisit_slam
