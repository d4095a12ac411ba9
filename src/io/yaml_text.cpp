// SPDX-License-Identifier: MIT
#include "revisit_slam/io/yaml_text.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace revisit_slam {
namespace {

constexpr std::size_t kLongest = 1 << 20;  // bytes

bool isControl(unsigned char byte) {
  return byte < ' ' && byte != '\t' && byte != '\n' && byte != '\r';
}

std::string lineOf(const std::string& text, std::size_t place) {
  return "line " + std::to_string(1 + std::count(text.begin(), text.begin() + place, '\n')) + ": ";
}

void requireReadable(const std::string& text) {
  if (text.size() > kLongest)
    throw std::runtime_error("it has more than " + std::to_string(kLongest) + " bytes");
  const std::size_t control = std::find_if(text.begin(), text.end(), isControl) - text.begin();
  if (control < text.size())
    throw std::runtime_error(lineOf(text, control) + "there is a control character");
  const std::size_t unfinished = text.find(":]");
  if (unfinished != std::string::npos)
    throw std::runtime_error(lineOf(text, unfinished) + "there is nothing between ':' and ']'");
}

}  // namespace

YAML::Node parseYaml(const std::string& text) {
  requireReadable(text);
  return YAML::Load(text + "\n");  // yaml-cpp 0.6 does not come back from a last ':' either
}

YAML::Node readYaml(const std::string& path) {
  try {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(std::strerror(errno));
    std::string text(kLongest + 1, '\0');
    file.read(&text[0], static_cast<std::streamsize>(text.size()));
    if (file.bad()) throw std::runtime_error("it is no file");
    text.resize(static_cast<std::size_t>(file.gcount()));
    return parseYaml(text);
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot read '" + path + "': " + error.what());
  }
}

}  // namespace revisit_slam
