// SPDX-License-Identifier: MIT
#include "revisit_slam/io/presets.h"

#include <gtest/gtest.h>

#include "revisit_slam/io/parameter_file.h"

namespace revisit_slam {
namespace {

TEST(Presets, AreTheFilesInCfg) {
  const std::vector<std::string> names = presetNames();
  ASSERT_FALSE(names.empty());
  for (const std::string& name : names) {
    const auto values = readPreset(name);
    EXPECT_FALSE(values.empty()) << name;
    EXPECT_EQ(values, readParameterFile("cfg/" + name + ".yaml")) << name;
  }
}

TEST(Presets, AnUnknownOneNamesThoseThatThereAre) {
  try {
    readPreset("papre");
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_STREQ(error.what(), "there is no preset 'papre'; there are: paper, small_board");
  }
}

}  // namespace
}  // namespace revisit_slam
