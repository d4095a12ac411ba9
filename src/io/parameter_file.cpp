// SPDX-License-Identifier: MIT
#include "revisit_slam/io/parameter_file.h"

#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "revisit_slam/io/yaml_text.h"

namespace revisit_slam {
namespace {

/// Far more than there are. An alias may contain itself, or stand for any number of others: what it
/// stands for has no end, or not in this memory.
constexpr int kDeepest = 16;
constexpr int kMostNodes = 10'000;

class Flattening {
 public:
  void flatten(const YAML::Node& node, const std::string& name, int depth = 0) {
    if (depth > kDeepest)
      throw ParameterError("parameter '" + name + "': groups are nested more than " +
                           std::to_string(kDeepest) + " deep; does an alias contain itself?");
    if (++nodes_ > kMostNodes)
      throw ParameterError("there are more than " + std::to_string(kMostNodes) + " parameters");
    if (node.IsScalar()) {
      values.emplace_back(name, node.Scalar());
    } else if (node.IsMap()) {
      for (const auto& entry : node)
        flatten(entry.second, (name.empty() ? "" : name + "/") + entry.first.Scalar(), depth + 1);
    } else if (!node.IsNull()) {
      throw ParameterError("parameter '" + name + "' is a list, but must be a value or a group");
    }
  }

  std::vector<NamedText> values;

 private:
  int nodes_ = 0;
};

template <typename Read>
YAML::Node document(const std::string& failure, const Read& read) {
  try {
    return read();
  } catch (const std::exception& error) {
    throw ParameterError(failure + error.what());
  }
}

}  // namespace

std::vector<NamedText> readParameterFile(const std::string& path) {
  return flattened(document("", [&] { return readYaml(path); }));
}

std::vector<NamedText> parseParameterText(const std::string& yaml) {
  return flattened(document("cannot read parameters: ", [&] { return parseYaml(yaml); }));
}

std::vector<NamedText> flattened(const YAML::Node& node) {
  Flattening flattening;
  flattening.flatten(node, "");
  return std::move(flattening.values);
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
