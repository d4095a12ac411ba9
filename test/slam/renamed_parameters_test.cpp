// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/renamed_parameters.h"

#include <gtest/gtest.h>

#include <set>

#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {
namespace {

TEST(RenamedParameters, LeadFromNamesThatAreGoneToNamesThatExist) {
  SlamConfig config;
  std::set<std::string> names;
  for (const Parameter& parameter : parametersOf(config)) names.insert(parameter.name);
  std::set<std::string> old_names;
  for (const auto& [old_name, new_name] : kRenamedParameters) {
    EXPECT_EQ(names.count(old_name), 0u) << old_name;
    EXPECT_EQ(names.count(new_name), 1u) << new_name;
    EXPECT_TRUE(old_names.insert(old_name).second) << old_name;
  }
}

}  // namespace
}  // namespace revisit_slam
