// SPDX-License-Identifier: MIT
#include "revisit_slam/io/parameter_file.h"

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

namespace revisit_slam {
namespace {

/// Far more than there are. An alias may contain itself, or stand for any number of others: what it
/// stands for has no end, or not in this memory.
constexpr int kDeepest = 16;
constexpr int kMostNodes = 10'000;
constexpr std::uintmax_t kLargestFile = 1 << 20;  // bytes

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

/// The parser takes many times the memory of what it reads.
void requireModest(const std::string& path) {
  std::error_code unreadable;  // which the parser says better
  const std::uintmax_t size = std::filesystem::file_size(path, unreadable);
  if (!unreadable && size > kLargestFile)
    throw ParameterError("cannot read the parameter file '" + path + "': it has more than " +
                         std::to_string(kLargestFile) + " bytes");
}

}  // namespace

std::vector<NamedText> readParameterFile(const std::string& path) {
  requireModest(path);
  try {
    return flattened(YAML::LoadFile(path));
  } catch (const YAML::Exception& error) {
    throw ParameterError("cannot read the parameter file '" + path + "': " + error.what());
  }
}

std::vector<NamedText> parseParameterText(const std::string& yaml) {
  try {
    return flattened(YAML::Load(yaml));
  } catch (const YAML::Exception& error) {
    throw ParameterError(std::string("cannot read parameters: ") + error.what());
  }
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
