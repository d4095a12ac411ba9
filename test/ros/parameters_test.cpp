// SPDX-License-Identifier: MIT
// cfg/LiveOdometry.cfg repeats some parameters of OdometryConfig: the two must agree.
#include <gtest/gtest.h>
#include <revisit_slam/LiveOdometryConfig.h>

#include <map>

#include "revisit_slam/odometry/odometry_config.h"

namespace revisit_slam {
namespace {

std::map<std::string, Parameter> parametersByName(OdometryConfig& config) {
  std::map<std::string, Parameter> by_name;
  for (const Parameter& parameter : parametersOf(config)) by_name[parameter.name] = parameter;
  return by_name;
}

dynamic_reconfigure::Config messageOf(const LiveOdometryConfig& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  return message;
}

TEST(LiveParameters, numbersHaveTheDefaultsAndRangesOfTheOdometry) {
  OdometryConfig config;
  const auto odometry = parametersByName(config);
  const auto defaults = messageOf(LiveOdometryConfig::__getDefault__());
  const auto lowest = messageOf(LiveOdometryConfig::__getMin__());
  const auto highest = messageOf(LiveOdometryConfig::__getMax__());
  EXPECT_FALSE(defaults.doubles.empty());
  EXPECT_TRUE(defaults.ints.empty() && defaults.strs.empty());
  for (std::size_t i = 0; i < defaults.doubles.size(); ++i) {
    const std::string& name = defaults.doubles[i].name;
    ASSERT_EQ(odometry.count(name), 1u) << name;
    const Parameter& parameter = odometry.at(name);
    EXPECT_EQ(defaults.doubles[i].value, *std::get<double*>(parameter.value)) << name;
    EXPECT_EQ(lowest.doubles[i].value, parameter.range.lowest) << name;
    EXPECT_EQ(highest.doubles[i].value, parameter.range.highest) << name;
  }
}

TEST(LiveParameters, switchesHaveTheDefaultsOfTheOdometry) {
  OdometryConfig config;
  const auto odometry = parametersByName(config);
  for (const auto& flag : messageOf(LiveOdometryConfig::__getDefault__()).bools) {
    ASSERT_EQ(odometry.count(flag.name), 1u) << flag.name;
    EXPECT_EQ(flag.value != 0, *std::get<bool*>(odometry.at(flag.name).value)) << flag.name;
  }
}

}  // namespace
}  // namespace revisit_slam
