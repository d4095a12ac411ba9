// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/slam_config.h"

#include <gtest/gtest.h>

#include <set>

#include "revisit_slam/io/presets.h"
#include "revisit_slam/slam/read_config.h"

namespace revisit_slam {
namespace {

TEST(SlamConfig, DeclaresEachParameterOnceWithAnAllowedDefault) {
  SlamConfig config;
  const auto parameters = parametersOf(config);
  EXPECT_NO_THROW(check(parameters));
  std::set<std::string> names;
  for (const Parameter& parameter : parameters) {
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name;
    EXPECT_FALSE(parameter.description.empty()) << parameter.name;
  }
}

TEST(SlamConfig, TakesAllPresets) {
  for (const std::string& preset : presetNames()) {
    std::vector<std::string> warnings;
    EXPECT_NO_THROW(readConfig({preset, "", {}, ""}, warnings)) << preset;
    EXPECT_TRUE(warnings.empty()) << preset;
  }
}

}  // namespace
}  // namespace revisit_slam
