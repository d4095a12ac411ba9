// SPDX-License-Identifier: MIT
#include "revisit_slam/io/folder_lock.h"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "support/contains.h"
#include "support/temporary_folder.h"

namespace {
std::function<void()> before_lock;  // what somebody else does
}  // namespace

/// Of the whole program.
extern "C" int flock(int file, int operation) {
  if (const auto other = std::exchange(before_lock, {})) other();
  return static_cast<int>(syscall(SYS_flock, file, operation));
}

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

/// Between opening the file and locking it.
TEST(FolderLock, AFileThatTheOneBeforeRemovesJustThenIsNoLock) {
  const TemporaryFolder folder;
  const std::string path = folder.with("lock", "");
  before_lock = [&] { std::remove(path.c_str()); };
  const FolderLock lock(folder.file(""));
  EXPECT_TRUE(isLocked(folder.file("")));
  EXPECT_THROW(FolderLock(folder.file("")), std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
