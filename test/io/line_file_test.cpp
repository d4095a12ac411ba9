// SPDX-License-Identifier: MIT
#include "revisit_slam/io/line_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(LineFile, IsMadeWithTheFirstLine) {
  const TemporaryFolder folder;
  LineFile lines(folder.file("a.csv"), "number\n");
  EXPECT_FALSE(lines.hasLines());
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.csv")));
  lines.add("1\n");
  lines.add("2\n");
  EXPECT_TRUE(lines.hasLines());
  EXPECT_EQ(textOf(folder.file("a.csv")), "number\n1\n2\n");
}

TEST(LineFile, LinesWaitUntilTheyCanBeWritten) {
  const TemporaryFolder folder;
  LineFile lines(folder.file("later/a.csv"), "number\n");
  lines.add("1\n");
  EXPECT_TRUE(lines.hasLines());
  EXPECT_NE(lines.problem().find("later/a.csv"), std::string::npos) << lines.problem();
  EXPECT_THROW(lines.flush(), std::runtime_error);
  std::filesystem::create_directory(folder.file("later"));
  lines.add("2\n");
  EXPECT_EQ(lines.problem(), "");
  EXPECT_EQ(textOf(folder.file("later/a.csv")), "number\n1\n2\n");
}

TEST(LineFile, IsMadeAnewWhereItIsRemoved) {
  const TemporaryFolder folder;
  LineFile lines(folder.file("a.csv"), "number\n");
  lines.add("1\n");
  std::filesystem::remove(folder.file("a.csv"));
  lines.add("2\n");
  EXPECT_EQ(textOf(folder.file("a.csv")), "number\n2\n");
}

}  // namespace
}  // namespace revisit_slam
