// SPDX-License-Identifier: MIT
#include "revisit_slam/io/folder_lock.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>

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

/// One makes the file that the other has just removed.
TEST(FolderLock, NoTwoHaveItAtATimeHoweverOftenItIsGivenBack) {
  const TemporaryFolder folder;
  std::atomic<int> holders{0}, most{0}, locked{0};
  const auto lockAndGiveBack = [&] {
    for (int i = 0; i < 2000; ++i) try {
        const FolderLock lock(folder.file(""));
        most = std::max<int>(most, ++holders);
        ++locked;
        --holders;
      } catch (const std::runtime_error&) {
        // the other has it
      }
  };
  std::thread other(lockAndGiveBack);
  lockAndGiveBack();
  other.join();
  EXPECT_EQ(most, 1);
  EXPECT_GT(locked, 2);
}

}  // namespace
}  // namespace revisit_slam
