// SPDX-License-Identifier: MIT
#include "revisit_slam/io/parameter_file.h"

#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>

namespace revisit_slam {
namespace {

void flatten(const YAML::Node& node, const std::string& name, std::vector<NamedText>& values) {
  if (node.IsScalar()) {
    values.emplace_back(name, node.Scalar());
  } else if (node.IsMap()) {
    for (const auto& entry : node)
      flatten(entry.second, (name.empty() ? "" : name + "/") + entry.first.Scalar(), values);
  } else if (!node.IsNull()) {
    throw ParameterError("parameter '" + name + "' is a list, but must be a value or a group");
  }
}

}  // namespace

std::vector<NamedText> readParameterFile(const std::string& path) {
  std::vector<NamedText> values;
  try {
    flatten(YAML::LoadFile(path), "", values);
  } catch (const YAML::Exception& error) {
    throw ParameterError("cannot read the parameter file '" + path + "': " + error.what());
  }
  return values;
}

std::vector<NamedText> parseParameterText(const std::string& yaml) {
  std::vector<NamedText> values;
  try {
    flatten(YAML::Load(yaml), "", values);
  } catch (const YAML::Exception& error) {
    throw ParameterError(std::string("cannot read parameters: ") + error.what());
  }
  return values;
}

std::vector<NamedText> flattened(const YAML::Node& node) {
  std::vector<NamedText> values;
  flatten(node, "", values);
  return values;
}

nlohmann::json toJson(const std::vector<Parameter>& parameters) {
  nlohmann::json json = nlohmann::json::object();
  for (const Parameter& parameter : parameters)
    std::visit(
        [&](auto* value) { json[nlohmann::json::json_pointer("/" + parameter.name)] = *value; },
        parameter.value);
  return json;
}

}  // namespace revisit_slam
