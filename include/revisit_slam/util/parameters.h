// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace revisit_slam {

/// A parameter that cannot be used. The message names the parameter, its value and what is allowed.
class ParameterError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Closed interval of the values that a number may take.
struct Range {
  double lowest;
  double highest;
};

/// The words that a text parameter may be; empty allows any.
using Choices = std::vector<std::string>;

/// Every module has a struct of parameters, each member with its default, and one function template
///
///   template <typename Visitor> void visit(Visitor& v) {
///     v("voxel_size", voxel_size, Range{0.01, 100.0}, "m", "what it does");
///     v("time_field", time_field, Choices{}, "", "what it does");
///     v("deskew", deskew, "what it does");
///     v.group("map", map);  // a struct of parameters within this one
///   }
///
/// which names them. Reading, checking, writing out and the tables of the documentation all work on
/// the list made from it, so that a parameter is declared in one place.
struct Parameter {
  std::string name;  ///< with the names of its groups: "odometry/map/voxel_size"
  std::variant<bool*, int*, double*, std::string*> value;
  Range range{0.0, 0.0};  ///< of numbers
  Choices choices;        ///< of texts
  std::string unit;
  std::string description;
};

/// The visitor that lists the parameters of a struct.
class ParameterList {
 public:
  void operator()(const char* name, bool& value, const char* description);
  void operator()(const char* name, int& value, Range range, const char* unit,
                  const char* description);
  void operator()(const char* name, double& value, Range range, const char* unit,
                  const char* description);
  void operator()(const char* name, std::string& value, Choices choices, const char* unit,
                  const char* description);

  template <typename Config>
  void group(const char* name, Config& config) {
    const std::string outer = prefix_;
    prefix_ += std::string(name) + "/";
    config.visit(*this);
    prefix_ = outer;
  }

  const std::vector<Parameter>& parameters() const { return parameters_; }

 private:
  void add(const char* name, Parameter parameter, const char* description);

  std::string prefix_;
  std::vector<Parameter> parameters_;
};

/// The parameters of `config`, pointing into it.
template <typename Config>
std::vector<Parameter> parametersOf(Config& config) {
  ParameterList list;
  config.visit(list);
  return list.parameters();
}

/// Name of a parameter and its value as text.
using NamedText = std::pair<std::string, std::string>;

/// Sets the parameters named, each after a check: a value that is refused is not set.
/// @throws ParameterError for an unknown name (with the nearest known one), a value of another
/// type, out of range or not among the choices.
void assign(const std::vector<Parameter>& parameters, const std::vector<NamedText>& values);

/// Old names of parameters that are accepted for one release: the old one, then the new one.
using RenamedParameters = std::vector<std::pair<std::string, std::string>>;

/// The same, with old names accepted. @return a warning for each old name used, naming the new one.
/// @throws ParameterError also where an old name and its new one are both given.
[[nodiscard]] std::vector<std::string> assign(const std::vector<Parameter>& parameters,
                                              const std::vector<NamedText>& values,
                                              const RenamedParameters& renamed);

/// Settings of a command line, each "group/name=value". @throws ParameterError for any other form.
std::vector<NamedText> parseSettings(const std::vector<std::string>& settings);

/// Checks all values. @throws ParameterError for the first that is not allowed.
void check(const std::vector<Parameter>& parameters);

/// The value as text, such that `assign` reads the same value back.
std::string valueText(const Parameter& parameter);

/// What the parameter may be, for messages and tables: "0.02 to 20 m", "auto | none".
std::string allowedText(const Parameter& parameter);

}  // namespace revisit_slam
