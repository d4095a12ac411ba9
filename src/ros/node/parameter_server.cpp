// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/parameter_server.h"

#include <XmlRpcValue.h>
#include <ros/param.h>

#include <sstream>

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

}  // namespace

std::vector<NamedText> readParameterServer(const ros::NodeHandle& node) {
  std::vector<NamedText> values;
  XmlRpc::XmlRpcValue tree;
  if (ros::param::get(node.getNamespace(), tree)) flatten(tree, "", values);
  return values;
}

}  // namespace revisit_slam
