// SPDX-License-Identifier: MIT
// cfg/*.cfg repeat some parameters of the groups that they are for: the two must agree.
#include <gtest/gtest.h>
#include <revisit_slam/LiveBackEndConfig.h>
#include <revisit_slam/LiveInformationConfig.h>
#include <revisit_slam/LiveLoopsConfig.h>
#include <revisit_slam/LiveOdometryConfig.h>
#include <revisit_slam/LiveRecognitionConfig.h>
#include <revisit_slam/LiveRetroactiveConfig.h>

#include <limits>
#include <map>

#include "revisit_slam/ros/node/live_parameters.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {
namespace {

template <typename Config>
std::map<std::string, Parameter> parametersByName(Config& config) {
  std::map<std::string, Parameter> by_name;
  for (const Parameter& parameter : parametersOf(config)) by_name[parameter.name] = parameter;
  return by_name;
}

template <typename Live>
dynamic_reconfigure::Config messageOf(const Live& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  return message;
}

template <typename Value, typename Entries>
void expectRanges(const std::map<std::string, Parameter>& parameters, const Entries& defaults,
                  const Entries& lowest, const Entries& highest) {
  for (std::size_t i = 0; i < defaults.size(); ++i) {
    const std::string& name = defaults[i].name;
    ASSERT_EQ(parameters.count(name), 1u) << name;
    const Parameter& parameter = parameters.at(name);
    EXPECT_EQ(defaults[i].value, *std::get<Value*>(parameter.value)) << name;
    EXPECT_EQ(lowest[i].value, parameter.range.lowest) << name;
    EXPECT_EQ(highest[i].value, parameter.range.highest) << name;
  }
}

template <typename Live, typename Config>
void expectAgreement() {
  Config config;
  const auto parameters = parametersByName(config);
  const auto defaults = messageOf(Live::__getDefault__());
  const auto lowest = messageOf(Live::__getMin__());
  const auto highest = messageOf(Live::__getMax__());
  EXPECT_FALSE(defaults.doubles.empty() && defaults.ints.empty() && defaults.bools.empty());
  EXPECT_TRUE(defaults.strs.empty());
  expectRanges<double>(parameters, defaults.doubles, lowest.doubles, highest.doubles);
  expectRanges<int>(parameters, defaults.ints, lowest.ints, highest.ints);
  for (const auto& flag : defaults.bools) {
    ASSERT_EQ(parameters.count(flag.name), 1u) << flag.name;
    EXPECT_EQ(flag.value != 0, *std::get<bool*>(parameters.at(flag.name).value)) << flag.name;
  }
}

TEST(LiveParameters, haveTheDefaultsAndRangesOfTheirGroups) {
  expectAgreement<LiveOdometryConfig, OdometryConfig>();
  expectAgreement<LiveInformationConfig, InformationConfig>();
  expectAgreement<LiveLoopsConfig, LoopsConfig>();
  expectAgreement<LiveRecognitionConfig, PlaceRecognitionConfig>();
  expectAgreement<LiveRetroactiveConfig, RetroactiveConfig>();
  expectAgreement<LiveBackEndConfig, BackEndConfig>();
}

TEST(LiveParameters, goThereAndBackAsTheyAre) {
  LiveLoopsConfig live = LiveLoopsConfig::__getDefault__();
  live.min_fitness = 0.1 + 0.2;  // needs all digits
  LoopsConfig config;
  assign(parametersOf(config), textsOf(messageOf(live)));
  EXPECT_EQ(config.closer.min_fitness, live.min_fitness);
  auto message = messageOf(LiveLoopsConfig::__getDefault__());
  fill(parametersOf(config), message);
  EXPECT_EQ(message.doubles[0].value, live.min_fitness);
}

TEST(LiveParameters, notANumberIsRefused) {
  LiveLoopsConfig live = LiveLoopsConfig::__getDefault__();
  live.min_fitness = std::numeric_limits<double>::quiet_NaN();
  LoopsConfig config;
  EXPECT_THROW(assign(parametersOf(config), textsOf(messageOf(live))), ParameterError);
}

}  // namespace
}  // namespace revisit_slam
