// SPDX-License-Identifier: MIT
#include "revisit_slam/io/parameter_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "revisit_slam/odometry/odometry_config.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

std::string messageOfReading(const std::string& path) {
  try {
    readParameterFile(path);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ParameterFile, NestsAsTheGroupsDo) {
  const TemporaryFolder folder;
  const auto values = readParameterFile(folder.with("a.yaml",
                                                    "max_range: 80  # metres\n"
                                                    "map:\n"
                                                    "  voxel_size: 0.5\n"
                                                    "  deeper: {name: 'a b', empty: ''}\n"
                                                    "nothing:\n"
                                                    "deskew: false\n"));
  EXPECT_EQ(values, (std::vector<NamedText>{{"max_range", "80"},
                                            {"map/voxel_size", "0.5"},
                                            {"map/deeper/name", "a b"},
                                            {"map/deeper/empty", ""},
                                            {"deskew", "false"}}));
}

TEST(ParameterFile, SetsAConfigOfGroups) {
  const TemporaryFolder folder;
  OdometryConfig config;
  assign(parametersOf(config),
         readParameterFile(folder.with("a.yaml", "map: {voxel_size: 0.5}\ndeskew: false\n")));
  EXPECT_EQ(config.map.voxel_size, 0.5);
  EXPECT_FALSE(config.deskew);
  EXPECT_EQ(config.max_range, OdometryConfig().max_range);
}

TEST(ParameterFile, AnEmptyFileSetsNothing) {
  const TemporaryFolder folder;
  EXPECT_TRUE(readParameterFile(folder.with("a.yaml", "# nothing\n")).empty());
}

TEST(ParameterFile, RefusesListsByName) {
  const TemporaryFolder folder;
  EXPECT_EQ(messageOfReading(folder.with("a.yaml", "map:\n  voxel_size: [1, 2]\n")),
            "parameter 'map/voxel_size' is a list, but must be a value or a group");
}

TEST(ParameterFile, NamesTheFileThatIsMissingOrNoYaml) {
  const TemporaryFolder folder;
  for (const std::string& path :
       {folder.file("missing.yaml"), folder.with("a.yaml", "map: {voxel_size: 1\n")}) {
    const std::string message = messageOfReading(path);
    EXPECT_NE(message.find(path), std::string::npos) << message;
  }
}

TEST(ParameterFile, RefusesAnAliasThatContainsItself) {
  const TemporaryFolder folder;
  const std::string message = messageOfReading(folder.with("a.yaml", "map: &map\n  map: *map\n"));
  EXPECT_NE(message.find("does an alias contain itself?"), std::string::npos) << message;
}

TEST(ParameterFile, RefusesAliasesThatStandForMoreThanMemoryHolds) {
  const TemporaryFolder folder;
  std::string yaml = "a0: &a0 {b: 1, c: 2, d: 3, e: 4, f: 5, g: 6, h: 7, i: 8, j: 9}\n";
  for (int i = 1; i < 10; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    yaml += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " {b: " + alias;
    for (const char letter : std::string("cdefghij"))
      yaml += std::string(", ") + letter + ": " + alias;
    yaml += "}\n";
  }
  const std::string message = messageOfReading(folder.with("a.yaml", yaml));
  EXPECT_NE(message.find("more than 10000 parameters"), std::string::npos) << message;
}

TEST(ParameterFile, RefusesDepthAndSizeThatNoParameterFileHas) {
  const TemporaryFolder folder;
  EXPECT_NE(messageOfReading(folder.with("deep.yaml", std::string(100'000, '['))), "accepted");
  const std::string large(2 << 20, '#');
  const std::string message = messageOfReading(folder.with("large.yaml", large));
  EXPECT_NE(message.find("more than 1048576 bytes"), std::string::npos) << message;
}

TEST(ParameterFile, JsonHasTheValuesInForceWithTheirTypes) {
  OdometryConfig config;
  config.map.voxel_size = 0.3;
  const nlohmann::json json = toJson(parametersOf(config));
  EXPECT_EQ(json["map"]["voxel_size"], 0.3);
  EXPECT_EQ(json["deskew"], true);
  EXPECT_TRUE(json["threads"].is_number_integer());
  EXPECT_EQ(json["threshold"].size(), 2u);
  EXPECT_EQ(toJson({}), nlohmann::json::object());
}

}  // namespace
}  // namespace revisit_slam
