// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_fields.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace revisit_slam {
namespace {

constexpr std::array<const char*, 20> known_names{
    "t",           "time",         "timestamp",      "timestamps",     "time_stamp",
    "offset_time", "time_offset",  "time_offset_ns", "offset_time_ns", "timeoffset",
    "offsettime",  "timestamp_ns", "timestamp_us",   "time_ns",        "time_us",
    "t_ns",        "t_us",         "relative_time",  "point_time",     "stamp"};

constexpr std::array<std::pair<const char*, TimeUnit>, 10> unit_endings{{
    {"nanoseconds", TimeUnit::ns},
    {"nanosec", TimeUnit::ns},
    {"nsec", TimeUnit::ns},
    {"_ns", TimeUnit::ns},
    {"microseconds", TimeUnit::us},
    {"usec", TimeUnit::us},
    {"_us", TimeUnit::us},
    {"milliseconds", TimeUnit::ms},
    {"msec", TimeUnit::ms},
    {"_ms", TimeUnit::ms},
}};

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

std::vector<PointField> findTimeFields(const PointView& view, const std::string& wanted) {
  std::vector<PointField> found;
  const auto add = [&](const std::string& name) {
    for (const PointField& field : view.fields) {
      const bool usable = field.type != NumberType::unknown && lowerCase(field.name) == name;
      if (usable) found.push_back(field);
    }
  };
  if (wanted != "auto") {
    add(lowerCase(wanted));
  } else {
    for (const char* name : known_names) add(name);
  }
  return found;
}

std::optional<TimeUnit> unitInName(const std::string& name) {
  const std::string lower = lowerCase(name);
  for (const auto& [ending, unit] : unit_endings) {
    if (endsWith(lower, ending)) return unit;
  }
  return std::nullopt;
}

}  // namespace revisit_slam
