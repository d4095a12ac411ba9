// SPDX-License-Identifier: MIT
#include "revisit_slam/io/whole_file.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(WholeFile, ReplacesTheOldFileAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  const std::string path = folder.with("run.json", "old");
  writeWholeText(path, "new text\n");
  EXPECT_EQ(textOf(path), "new text\n");
  const std::filesystem::directory_iterator files(std::filesystem::path(path).parent_path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(WholeFile, TheOldFileStaysUntilTheNewOneIsWhole) {
  const TemporaryFolder folder;
  const std::string path = folder.with("map.pcd", "old");
  writeWholeFile(path, [&](const std::string& temporary) {
    EXPECT_NE(temporary, path);
    std::ofstream(temporary) << "new";
    EXPECT_EQ(textOf(path), "old");
  });
  EXPECT_EQ(textOf(path), "new");
}

TEST(WholeFile, AWriterThatFailsLeavesTheOldFile) {
  const TemporaryFolder folder;
  const std::string path = folder.with("map.pcd", "old");
  const auto fails = [](const std::string& temporary) {
    std::ofstream(temporary) << "half";
    throw std::runtime_error("the disk is full");
  };
  EXPECT_THROW(writeWholeFile(path, fails), std::runtime_error);
  EXPECT_EQ(textOf(path), "old");
}

TEST(WholeFile, AWriterThatWritesNothingIsAnError) {
  const TemporaryFolder folder;
  const std::string path = folder.with("map.pcd", "old");
  EXPECT_THROW(writeWholeFile(path, [](const std::string&) {}), std::runtime_error);
  EXPECT_EQ(textOf(path), "old");
}

TEST(WholeFile, NamesTheFileThatItCannotWrite) {
  const std::string path = TemporaryFolder().file("gone/a.txt");
  try {
    writeWholeText(path, "text");
    FAIL() << "wrote into a folder that does not exist";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace revisit_slam
