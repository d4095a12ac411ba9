// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/parameter_server.h"

#include <XmlRpcValue.h>
#include <ros/param.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "revisit_slam/io/presets.h"

namespace revisit_slam {
namespace {

std::string scalarText(XmlRpc::XmlRpcValue& value) {
  if (value.getType() == XmlRpc::XmlRpcValue::TypeString) return value;
  if (value.getType() == XmlRpc::XmlRpcValue::TypeBoolean)
    return static_cast<bool>(value) ? "true" : "false";
  if (value.getType() == XmlRpc::XmlRpcValue::TypeInt)
    return std::to_string(static_cast<int>(value));
  std::ostringstream text;
  text.precision(17);
  text << static_cast<double>(value);
  return text.str();
}

void flatten(XmlRpc::XmlRpcValue& value, const std::string& name, std::vector<NamedText>& values) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeStruct:
      for (auto& entry : value)
        flatten(entry.second, (name.empty() ? "" : name + "/") + entry.first, values);
      break;
    case XmlRpc::XmlRpcValue::TypeString:
    case XmlRpc::XmlRpcValue::TypeBoolean:
    case XmlRpc::XmlRpcValue::TypeInt:
    case XmlRpc::XmlRpcValue::TypeDouble:
      values.emplace_back(name, scalarText(value));
      break;
    default:
      throw ParameterError("parameter '" + name + "' is neither a value nor a group");
  }
}

/// The values of the preset whose name is among them come first, so that others go before its own.
std::vector<NamedText> withPreset(std::vector<NamedText> values) {
  const auto preset =
      std::find_if(values.begin(), values.end(), [](const auto& v) { return v.first == "preset"; });
  if (preset == values.end()) return values;
  std::vector<NamedText> all = readPreset(preset->second);
  values.erase(preset);
  all.insert(all.end(), values.begin(), values.end());
  return all;
}

}  // namespace

std::vector<NamedText> readParameterServer(const ros::NodeHandle& node) {
  std::vector<NamedText> values;
  XmlRpc::XmlRpcValue tree;
  if (ros::param::get(node.getNamespace(), tree)) flatten(tree, "", values);
  return withPreset(std::move(values));
}

}  // namespace revisit_slam
