// SPDX-License-Identifier: MIT
#include "revisit_slam/io/yaml_text.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <stdexcept>

#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

std::string refusalOf(const std::string& yaml) {
  try {
    parseYaml(yaml);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(YamlText, ReadsWhatEndsWithoutALineBreak) {
  EXPECT_EQ(parseYaml("a: {b: 1}")["a"]["b"].as<int>(), 1);
  EXPECT_EQ(parseYaml("a: \"\xc3\xa9\"\r\n")["a"].as<std::string>(), "\xc3\xa9");
  EXPECT_TRUE(parseYaml("").IsNull());
}

TEST(YamlText, SaysWhereThereIsAControlCharacter) {
  EXPECT_EQ(refusalOf("a: 1\nb: {c:\x04 2}\n"), "line 2: there is a control character");
  EXPECT_EQ(refusalOf(std::string("a: \0", 4)), "line 1: there is a control character");
}

TEST(YamlText, SaysWhereAColonHasNoValue) {
  EXPECT_EQ(refusalOf("a: 1\n\nb: {c:] 2}\n"), "line 3: there is nothing between ':' and ']'");
}

// Of these yaml-cpp 0.6 made scalars until there was no memory.
TEST(YamlText, AnswersWhatEndsWithinAMap) {
  EXPECT_NE(refusalOf("a: &a {b:"), "accepted");
  EXPECT_NE(refusalOf("a: {b: 'x', c:"), "accepted");
}

TEST(YamlText, NamesTheFileThatCannotBeRead) {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.file("missing.yaml"), folder.file(""),
                                  folder.with("large.yaml", std::string((1 << 20) + 1, '#')),
                                  folder.with("map.yaml", "a: {b:")}) {
    try {
      readYaml(path);
      ADD_FAILURE() << path;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("'" + path + "'"), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace revisit_slam
