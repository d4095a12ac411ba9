// SPDX-License-Identifier: MIT
#include "revisit_slam/util/parameters.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <sstream>
#include <type_traits>

namespace revisit_slam {
namespace {

std::string numberText(double value) {
  for (int digits = 6;; ++digits) {  // the shortest text that reads back as the same number
    std::ostringstream text;
    text.precision(digits);
    text << value;
    if (digits >= 17 || std::strtod(text.str().c_str(), nullptr) == value) return text.str();
  }
}

/// Edits (insert, delete, replace) between two names.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = std::exchange(row[j], std::min({replaced, row[j] + 1, row[j - 1] + 1}));
    }
  }
  return row.back();
}

std::string lastPart(const std::string& name) {
  return name.substr(name.rfind('/') + 1);
}

bool isGiven(const std::vector<NamedText>& values, const std::string& name) {
  return std::any_of(values.begin(), values.end(),
                     [&](const NamedText& value) { return value.first == name; });
}

const Parameter& find(const std::vector<Parameter>& parameters, const std::string& name) {
  const Parameter* nearest = nullptr;
  std::size_t smallest = std::string::npos;
  for (const Parameter& parameter : parameters) {
    if (parameter.name == name) return parameter;
    const std::size_t distance =
        std::min(editDistance(parameter.name, name), editDistance(lastPart(parameter.name), name));
    if (distance < smallest) {
      smallest = distance;
      nearest = &parameter;
    }
  }
  throw ParameterError("unknown parameter '" + name + "'" +
                       (nearest ? "; did you mean '" + nearest->name + "'?" : ""));
}

template <typename T>
std::optional<T> parse(const std::string& text) {
  std::istringstream stream(text);
  T value;
  if (!(stream >> value) || !(stream >> std::ws).eof()) return std::nullopt;
  return value;
}

template <>
std::optional<bool> parse(const std::string& text) {
  if (text == "true" || text == "True" || text == "1") return true;
  if (text == "false" || text == "False" || text == "0") return false;
  return std::nullopt;
}

template <>
std::optional<std::string> parse(const std::string& text) {
  return text;
}

template <typename T>
const char* typeName() {
  if (std::is_same<T, bool>::value) return "true or false";
  if (std::is_same<T, int>::value) return "a whole number";
  if (std::is_same<T, double>::value) return "a number";
  return "a text";
}

[[noreturn]] void refuse(const Parameter& parameter, const std::string& value,
                         const std::string& allowed) {
  throw ParameterError("parameter '" + parameter.name + "' is '" + value + "', but must be " +
                       allowed);
}

template <typename T>
bool allowed(const Parameter& parameter, const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    const Choices& choices = parameter.choices;
    return choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end();
  } else if constexpr (std::is_same_v<T, bool>) {
    return true;
  } else {  // false for NaN
    return value >= parameter.range.lowest && value <= parameter.range.highest;
  }
}

}  // namespace

void ParameterList::operator()(const char* name, bool& value, const char* description) {
  Parameter parameter;
  parameter.value = &value;
  add(name, parameter, description);
}

void ParameterList::operator()(const char* name, int& value, Range range, const char* unit,
                               const char* description) {
  Parameter parameter;
  parameter.value = &value;
  parameter.range = range;
  parameter.unit = unit;
  add(name, parameter, description);
}

void ParameterList::operator()(const char* name, double& value, Range range, const char* unit,
                               const char* description) {
  Parameter parameter;
  parameter.value = &value;
  parameter.range = range;
  parameter.unit = unit;
  add(name, parameter, description);
}

void ParameterList::operator()(const char* name, std::string& value, Choices choices,
                               const char* unit, const char* description) {
  Parameter parameter;
  parameter.value = &value;
  parameter.choices = std::move(choices);
  parameter.unit = unit;
  add(name, parameter, description);
}

void ParameterList::add(const char* name, Parameter parameter, const char* description) {
  parameter.name = prefix_ + name;
  parameter.description = description;
  parameters_.push_back(std::move(parameter));
}

void assign(const std::vector<Parameter>& parameters, const std::vector<NamedText>& values) {
  for (const auto& [name, text] : values) {
    const Parameter& parameter = find(parameters, name);
    std::visit(
        [&, &text = text](auto* target) {
          using T = std::remove_pointer_t<decltype(target)>;
          const std::optional<T> value = parse<T>(text);
          if (!value) refuse(parameter, text, typeName<T>());
          if (!allowed(parameter, *value)) refuse(parameter, text, allowedText(parameter));
          *target = *value;
        },
        parameter.value);
  }
}

std::vector<std::string> assign(const std::vector<Parameter>& parameters,
                                const std::vector<NamedText>& values,
                                const RenamedParameters& renamed) {
  std::vector<std::string> warnings;
  std::vector<NamedText> with_new_names = values;
  for (const auto& [old_name, new_name] : renamed) {
    if (!isGiven(values, old_name)) continue;
    const std::string renaming = "parameter '" + old_name + "' is now called '" + new_name + "'";
    if (isGiven(values, new_name))
      throw ParameterError(renaming + "; give one of the two, not both");
    for (NamedText& value : with_new_names)
      if (value.first == old_name) value.first = new_name;
    warnings.push_back(renaming + "; the old name is accepted until the next release");
  }
  assign(parameters, with_new_names);
  return warnings;
}

std::vector<NamedText> parseSettings(const std::vector<std::string>& settings) {
  std::vector<NamedText> values;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
      throw ParameterError("--set " + setting + " is not of the form key=value");
    values.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
  }
  return values;
}

void check(const std::vector<Parameter>& parameters) {
  for (const Parameter& parameter : parameters) {
    const bool ok =
        std::visit([&](auto* value) { return allowed(parameter, *value); }, parameter.value);
    if (!ok) refuse(parameter, valueText(parameter), allowedText(parameter));
  }
}

std::string valueText(const Parameter& parameter) {
  if (const auto* flag = std::get_if<bool*>(&parameter.value)) return **flag ? "true" : "false";
  if (const auto* text = std::get_if<std::string*>(&parameter.value)) return **text;
  if (const auto* whole = std::get_if<int*>(&parameter.value)) return std::to_string(**whole);
  return numberText(**std::get_if<double*>(&parameter.value));
}

std::string allowedText(const Parameter& parameter) {
  if (std::holds_alternative<bool*>(parameter.value)) return "true | false";
  if (std::holds_alternative<std::string*>(parameter.value)) {
    std::string text;
    for (const std::string& choice : parameter.choices)
      text += (text.empty() ? "" : " | ") + choice;
    return text.empty() ? "any text" : text;
  }
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  return numberText(parameter.range.lowest) + " to " + numberText(parameter.range.highest) + unit;
}

}  // namespace revisit_slam
