// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_info.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/io/parameter_file.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/io/yaml_text.h"

namespace revisit_slam {
namespace {

constexpr double kLatest = 4.3e9;       // s: all that ROS can say
constexpr int kFormat = 3;              // the newest
constexpr int kFormatOfOneSession = 2;  // which older software can read

/// Where a parameter is in nested maps.
YAML::Node nested(const std::vector<NamedText>& parameters) {
  YAML::Node root(YAML::NodeType::Map);
  for (const auto& [name, value] : parameters) {
    YAML::Node group = root;
    std::size_t begin = 0;
    for (std::size_t end; (end = name.find('/', begin)) != std::string::npos; begin = end + 1) {
      const std::string key = name.substr(begin, end - begin);
      if (!group[key].IsDefined()) group[key] = YAML::Node(YAML::NodeType::Map);
      group.reset(group[key]);
    }
    group[name.substr(begin)] = value;
  }
  return root;
}

}  // namespace

std::string softwareVersion() {
  return REVISIT_SLAM_VERSION;
}

std::vector<NamedText> textOf(const std::vector<Parameter>& parameters) {
  std::vector<NamedText> values;
  values.reserve(parameters.size());
  for (const Parameter& parameter : parameters)
    values.emplace_back(parameter.name, valueText(parameter));
  return values;
}

void assignKnown(const std::vector<Parameter>& parameters, const std::vector<NamedText>& values) {
  std::vector<NamedText> known;
  std::copy_if(
      values.begin(), values.end(), std::back_inserter(known), [&](const NamedText& value) {
        return std::any_of(parameters.begin(), parameters.end(), [&](const Parameter& parameter) {
          return parameter.name == value.first;
        });
      });
  assign(parameters, known);
}

void writeSessionInfo(const std::string& path, const SessionInfo& info) {
  YAML::Node session;
  session["format"] = info.joined.empty() ? kFormatOfOneSession : kFormat;
  session["software"] = "revisit_slam " + info.software;
  session["state"] = info.closed ? "closed" : "open";
  session["session"] = info.id.value;
  session["start"] = info.start.nanoseconds;
  session["frames"]["map"] = info.map_frame;
  session["frames"]["odom"] = info.odom_frame;
  session["frames"]["base"] = info.base_frame;
  session["gauge"] = "first scan";
  if (info.datum) {
    session["datum"]["latitude"] = info.datum->latitude;
    session["datum"]["longitude"] = info.datum->longitude;
    session["datum"]["altitude"] = info.datum->altitude;
  }
  session["sensor"] = info.sensor;
  for (const JoinedSession& joined : info.joined) {
    YAML::Node entry;
    entry["session"] = joined.id.value;
    entry["start"] = joined.start.nanoseconds;
    entry["sensor"] = joined.sensor;
    entry["from"] = joined.from;
    session["joined"].push_back(entry);
  }
  session["parameters"] = nested(info.parameters);
  writeWholeText(path, YAML::Dump(session) + "\n");
}

SessionInfo readSessionInfo(const std::string& path) {
  if (!std::filesystem::exists(path))
    throw std::runtime_error("there is no '" + path + "': the folder is no session");
  SessionInfo info;
  try {
    const YAML::Node session = readYaml(path);
    const int format = session["format"].as<int>();
    if (format > kFormat)
      throw std::runtime_error("format " + std::to_string(format) + ", this software knows " +
                               std::to_string(kFormat));
    info.closed = session["state"].as<std::string>() == "closed";
    info.software = session["software"].as<std::string>();
    info.id = SessionId{session["session"].as<std::uint32_t>()};
    info.start = {session["start"].as<std::int64_t>()};
    if (info.start < Stamp{} || Stamp::fromSeconds(kLatest) < info.start)
      throw std::runtime_error("it has begun at no time");
    info.map_frame = session["frames"]["map"].as<std::string>();
    info.odom_frame = session["frames"]["odom"].as<std::string>();
    info.base_frame = session["frames"]["base"].as<std::string>();
    info.sensor = session["sensor"].as<std::string>();
    for (const YAML::Node& entry : session["joined"])
      info.joined.push_back({SessionId{entry["session"].as<std::uint32_t>()},
                             {entry["start"].as<std::int64_t>()},
                             entry["sensor"].as<std::string>(),
                             entry["from"].as<std::string>()});
    if (const YAML::Node datum = session["datum"])
      info.datum = GeodeticPosition{datum["latitude"].as<double>(), datum["longitude"].as<double>(),
                                    datum["altitude"].as<double>()};
    if (info.datum && !isValid(*info.datum)) throw std::runtime_error("the datum is no position");
    info.parameters = flattened(session["parameters"]);
  } catch (const std::exception& error) {
    throw std::runtime_error("'" + path + "' cannot be used: " + error.what());
  }
  return info;
}

}  // namespace revisit_slam
