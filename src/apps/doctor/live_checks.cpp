// SPDX-License-Identifier: MIT
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/master.h>
#include <ros/ros.h>
#include <tf2_ros/transform_listener.h>
#include <topic_tools/shape_shifter.h>

#include <algorithm>
#include <map>
#include <memory>
#include <regex>
#include <utility>

#include "checks.h"
#include "revisit_slam/ros/input/scan_examination.h"
#include "revisit_slam/ros/messages/connected_frames.h"
#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/ros/node/scan_subscription.h"

namespace revisit_slam {
namespace {

using Level = Finding::Level;

RawMessage rawMessageOf(const topic_tools::ShapeShifter& message) {
  RawMessage raw{message.getDataType(),
                 message.getMD5Sum(),
                 message.getMessageDefinition(),
                 {},
                 toStamp(ros::Time::now())};
  raw.bytes.resize(message.size());
  ros::serialization::OStream out(raw.bytes.data(), message.size());
  message.write(out);
  return raw;
}

Finding aboutClock() {
  bool simulated = false;
  ros::param::get("/use_sim_time", simulated);
  if (!simulated) return {Level::good, "clock", "that of the machine", ""};
  if (!ros::Time::now().isZero()) return {Level::good, "clock", "simulated, on /clock", ""};
  return {Level::fault, "clock", "/use_sim_time is true, but nobody publishes /clock",
          "play recordings with rosbag play --clock, or for a live sensor call rosparam set "
          "/use_sim_time false and restart all nodes"};
}

/// What runs and is not well, by its own diagnostics.
class Nodes {
 public:
  explicit Nodes(ros::NodeHandle& node)
      : subscriber_(node.subscribe("/diagnostics", 1000, &Nodes::take, this)) {}

  std::vector<Finding> findings() const {
    std::vector<Finding> findings;
    for (const auto& [name, status] : newest_)
      findings.push_back({status.level == status.OK     ? Level::good
                          : status.level == status.WARN ? Level::warning
                                                        : Level::fault,
                          name, status.message, ""});
    return findings;
  }

 private:
  void take(const diagnostic_msgs::DiagnosticArray& array) {
    static const std::regex own(".*: (odometry|information|maps|graph|localization)");
    for (const auto& status : array.status)
      if (std::regex_match(status.name, own)) newest_[status.name] = status;
  }

  std::map<std::string, diagnostic_msgs::DiagnosticStatus> newest_;
  ros::Subscriber subscriber_;
};

/// The topic to look at; empty where that cannot be said, for which there is a finding then.
std::string chooseTopic(const std::string& wanted, Diagnosis& diagnosis) {
  const std::vector<TypedTopic> published = publishedTopics(), scans = scanTopics(published);
  const auto is_wanted = [&](const TypedTopic& topic) { return topic.name == wanted; };
  if (wanted.empty() && scans.size() == 1) return scans.front().name;
  if (std::any_of(scans.begin(), scans.end(), is_wanted)) return wanted;
  if (wanted.empty() && scans.size() > 1)
    diagnosis.findings.push_back(
        {Level::fault, "topic", "there are several with scans",
         "choose one with --points, or merge sensors of one robot by input/topics: " +
             namesOf(scans)});
  else
    diagnosis.findings.push_back(
        {Level::fault, "topic",
         wanted.empty() ? "no topic with scans is published" : describeSilence({wanted}, published),
         wanted.empty() ? "start the driver, or rosbag play --clock" : ""});
  return "";
}

/// What is heard of one sensor.
struct Heard {
  Heard(std::string topic, const SlamConfig& config)
      : topic(std::move(topic)), examination(config) {}

  std::string topic;
  ScanExamination examination;
  ros::Subscriber subscriber;
};

std::vector<std::unique_ptr<Heard>> subscribe(ros::NodeHandle& node, const Patient& patient,
                                              Diagnosis& diagnosis) {
  std::vector<std::unique_ptr<Heard>> sensors;
  for (const std::string& wanted : topicsOf(patient)) {
    const std::string topic =
        chooseTopic(wanted.empty() ? wanted : node.resolveName(wanted), diagnosis);
    if (topic.empty()) continue;
    sensors.push_back(std::make_unique<Heard>(topic, patient.config));
    sensors.back()->subscriber = node.subscribe<topic_tools::ShapeShifter>(
        topic, 0,
        [heard = sensors.back().get()](const topic_tools::ShapeShifter::ConstPtr& message) {
          heard->examination.add(rawMessageOf(*message));
        });
  }
  return sensors;
}

/// One sensor. @return whether TF has its place on the robot.
bool check(Heard& heard, const std::string& base, const tf2_ros::Buffer& buffer,
           std::vector<Finding>& findings) {
  if (heard.examination.messages() == 0) {
    findings.push_back(
        {Level::fault, "topic", describeSilence({heard.topic}, publishedTopics()), ""});
    return false;
  }
  findings.push_back({Level::good, "topic", heard.topic, ""});
  for (const Finding& finding : heard.examination.findings()) findings.push_back(finding);
  const std::string sensor = heard.examination.frame();
  const std::vector<std::string> connected = framesConnectedWith(sensor, buffer);
  const bool is_known = std::count(connected.begin(), connected.end(), base) > 0;
  findings.push_back(aboutTransform(base, sensor, is_known, connected));
  return is_known;
}

std::string argumentFor(const std::vector<std::unique_ptr<Heard>>& sensors) {
  std::vector<std::string> topics;
  for (const auto& heard : sensors) topics.push_back(heard->topic);
  if (topics.size() > 1) return "topics:=\"" + betweenSpaces(topics) + "\"";
  for (const TypedTopic& published : publishedTopics())
    if (published.name == topics.front()) return argumentFor(published);
  return "points:=" + topics.front();
}

void listen(double seconds) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (ros::ok() && ros::WallTime::now() < end)
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
}

}  // namespace

Finding checkManager(const std::string& wanted) {
  const std::string name = ros::names::resolve(wanted);
  const std::string ending = "/load_nodelet";
  std::string managers;
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  if (ros::master::execute("getSystemState", request, response, payload, false)) {
    XmlRpc::XmlRpcValue& services = payload[2];
    for (int i = 0; i < services.size(); ++i) {
      const std::string service = services[i][0];
      const std::size_t at = service.rfind(ending);
      if (at == std::string::npos || at + ending.size() != service.size()) continue;
      if (service.substr(0, at) == name) return {Level::good, "nodelet manager", name, ""};
      managers += (managers.empty() ? "" : ", ") + service.substr(0, at);
    }
  }
  return {Level::fault, "nodelet manager", "there is none of the name " + name,
          managers.empty() ? "none runs: start without start_manager:=false"
                           : "start with manager:= one of " + managers};
}

Diagnosis checkLive(const Patient& patient) {
  Diagnosis diagnosis;
  if (!ros::master::check()) {
    diagnosis.findings.push_back({Level::fault, "master",
                                  "none answers at " + ros::master::getURI(),
                                  "start a launch file or roscore, or set ROS_MASTER_URI"});
    return diagnosis;
  }
  ros::NodeHandle node;
  tf2_ros::Buffer buffer;
  const tf2_ros::TransformListener listener(buffer, node, false);
  const Nodes nodes(node);
  const std::vector<std::unique_ptr<Heard>> sensors = subscribe(node, patient, diagnosis);
  listen(patient.seconds);
  std::vector<Finding>& findings = diagnosis.findings;
  findings.insert(findings.begin(), aboutClock());
  if (!patient.manager.empty()) findings.push_back(checkManager(patient.manager));
  bool with_base = true;
  for (const auto& heard : sensors)
    with_base &= check(*heard, patient.config.frames.base, buffer, findings);
  if (!sensors.empty())
    diagnosis.command = "roslaunch revisit_slam slam.launch " + argumentFor(sensors) +
                        " base_frame:=" + (with_base ? patient.config.frames.base : "none") +
                        " folder:=maps";
  for (const Finding& finding : nodes.findings()) findings.push_back(finding);
  return diagnosis;
}

}  // namespace revisit_slam
