// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/live_parameters.h"

#include <sstream>

namespace revisit_slam {
namespace {

std::string textOf(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

/// The value of the parameter of that name, if it is of that type.
template <typename Value, typename Entries>
void fillEntries(const std::vector<Parameter>& parameters, Entries& entries) {
  for (auto& entry : entries)
    for (const Parameter& parameter : parameters)
      if (parameter.name == entry.name)
        if (Value* const* value = std::get_if<Value*>(&parameter.value)) entry.value = **value;
}

}  // namespace

std::vector<NamedText> textsOf(const dynamic_reconfigure::Config& values) {
  std::vector<NamedText> texts;
  for (const auto& entry : values.bools)
    texts.emplace_back(entry.name, entry.value != 0 ? "true" : "false");
  for (const auto& entry : values.ints) texts.emplace_back(entry.name, std::to_string(entry.value));
  for (const auto& entry : values.doubles) texts.emplace_back(entry.name, textOf(entry.value));
  for (const auto& entry : values.strs) texts.emplace_back(entry.name, entry.value);
  return texts;
}

void fill(const std::vector<Parameter>& parameters, dynamic_reconfigure::Config& values) {
  fillEntries<bool>(parameters, values.bools);
  fillEntries<int>(parameters, values.ints);
  fillEntries<double>(parameters, values.doubles);
  fillEntries<std::string>(parameters, values.strs);
}

}  // namespace revisit_slam
