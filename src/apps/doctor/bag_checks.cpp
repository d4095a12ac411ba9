// SPDX-License-Identifier: MIT
#include "checks.h"
#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/ros/input/scan_examination.h"

namespace revisit_slam {
namespace {

using Level = Finding::Level;

/// Text and remedy of a message that has both, with a semicolon between them.
Finding faultOf(const std::string& part, const std::string& message) {
  const std::size_t split = message.find("; ");
  return {Level::fault, part, message.substr(0, split),
          split == std::string::npos ? "" : message.substr(split + 2)};
}

Finding aboutTopic(BagScans& scans) {
  const double seconds = (scans.messages().getEndTime() - scans.messages().getBeginTime()).toSec();
  char text[96];
  std::snprintf(text, sizeof(text), ", %zu messages in %.1f s", scans.size(), seconds);
  if (scans.size() == 0)
    return {Level::fault, "topic", scans.topic() + " has no messages", "record anew"};
  return {Level::good, "topic", scans.topic() + text, ""};
}

void examine(BagScans& scans, const Patient& patient, Diagnosis& diagnosis) {
  ScanExamination examination(patient.config);
  for (const rosbag::MessageInstance& instance : scans.messages()) {
    if (examination.messages() == patient.max_scans) break;
    examination.add(rawMessageOf(instance));
  }
  for (const Finding& finding : examination.findings()) diagnosis.findings.push_back(finding);
}

std::string commandFor(const Patient& patient, const std::vector<std::string>& topics,
                       bool with_base) {
  std::string command = "rosrun revisit_slam offline";
  for (const std::string& bag : patient.bags) command += " --bag " + bag;
  command += topics.size() == 1 ? " --points " + topics.front()
                                : " --set input/topics=\"" + betweenSpaces(topics) + "\"";
  return command + (with_base ? "" : " --base-frame none") + " --out result";
}

/// One sensor. @return whether TF has its place on the robot.
bool check(BagScans& scans, const Patient& patient, Diagnosis& diagnosis) {
  diagnosis.findings.push_back(aboutTopic(scans));
  if (scans.size() == 0) return false;
  if (patient.max_scans > 0) examine(scans, patient, diagnosis);
  const std::string base = patient.config.frames.base, sensor = scans.sensorFrame();
  const bool is_known = scans.findExtrinsics(base, sensor).has_value();
  Finding transform = aboutTransform(base, sensor, is_known, scans.framesAround(sensor));
  if (!scans.hasTransforms() && !base.empty())
    transform = {Level::hint, "transform", "the bag has no transforms",
                 "offline estimates the poses of the sensor itself; for launch files add "
                 "base_frame:=none"};
  diagnosis.findings.push_back(transform);
  return is_known;
}

}  // namespace

Diagnosis checkBags(const Patient& patient) {
  Diagnosis diagnosis;
  try {
    std::vector<std::string> topics;
    bool with_base = true;
    for (const std::string& topic : topicsOf(patient)) {
      BagScans scans(patient.bags, topic);
      topics.push_back(scans.topic());
      with_base &= check(scans, patient, diagnosis);
    }
    diagnosis.command = commandFor(patient, topics, with_base);
  } catch (const BagError& error) {
    diagnosis.findings.push_back(faultOf("bag", error.what()));
  } catch (const rosbag::BagException& error) {
    diagnosis.findings.push_back(
        {Level::fault, "bag", error.what(), "the recording is damaged: try rosbag reindex"});
  }
  return diagnosis;
}

}  // namespace revisit_slam
