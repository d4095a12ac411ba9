// SPDX-License-Identifier: MIT
#include "revisit_slam/io/folder_lock.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(FolderLock, AFolderInUseIsRefusedWithTheProcessThatUsesIt) {
  const TemporaryFolder folder;
  {
    const FolderLock lock(folder.file(""));
    EXPECT_TRUE(isLocked(folder.file("")));
    try {
      const FolderLock second(folder.file(""));
      FAIL() << "locked twice";
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(contains(error.what(), "in use by process " + std::to_string(getpid())))
          << error.what();
    }
  }
  EXPECT_FALSE(isLocked(folder.file("")));
  const FolderLock again(folder.file(""));
}

TEST(FolderLock, WhatAKilledProcessLeftIsNoLock) {
  const TemporaryFolder folder;
  folder.with("lock", "12345\n");
  EXPECT_FALSE(isLocked(folder.file("")));
  const FolderLock lock(folder.file(""));
}

}  // namespace
}  // namespace revisit_slam
