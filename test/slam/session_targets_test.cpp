// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/session_targets.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

std::string faultOf(const std::string& folder) {
  LiveConfig live;
  live.folder = folder;
  try {
    requireWritable(live);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

TEST(SessionTargets, AFolderIsMadeAndTriedOutWithoutATrace) {
  const TemporaryFolder folder;
  EXPECT_EQ(faultOf(folder.file("a/maps")), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("a/maps")));
  EXPECT_EQ(faultOf(""), "");
}

TEST(SessionTargets, WhatElseADriveWritesIntoItsFolderIsItsOwn) {
  const TemporaryFolder folder;
  LiveConfig live;
  live.folder = folder.file("maps");
  EXPECT_TRUE(liveTargets(live, "")(SessionId{1}, Stamp::fromSeconds(1.0)).is_ours);
}

TEST(SessionTargets, AFolderOfTheShellsHomeIsRefused) {
  const TemporaryFolder folder;
  EXPECT_NE(faultOf(folder.file("~/maps")).find("~ is not expanded"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("")));
}

TEST(SessionTargets, AFolderThatCannotBeWrittenIsRefusedWithTheReason) {
  for (const char* folder : {"/proc/maps", "/proc"}) {
    const std::string fault = faultOf(folder);
    EXPECT_TRUE(contains(fault, std::string("live/folder is '") + folder + "'")) << fault;
    EXPECT_TRUE(contains(fault, "choose another, for example folder:=/")) << fault;
  }
  const TemporaryFolder other;
  other.with("file", "");
  EXPECT_TRUE(contains(faultOf(other.file("file")), "directory")) << faultOf(other.file("file"));
}

}  // namespace
}  // namespace revisit_slam
