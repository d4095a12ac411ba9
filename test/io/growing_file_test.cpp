// SPDX-License-Identifier: MIT
#include "revisit_slam/io/growing_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "support/contains.h"
#include "support/failing_sync.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

/// No file of the process may be larger, as if the disk were full.
class LargestFile {
 public:
  explicit LargestFile(rlim_t bytes) {
    old_handler_ = signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~LargestFile() {
    setrlimit(RLIMIT_FSIZE, &old_);
    signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

TEST(GrowingFile, WhatTheDiskDidNotTakeIsAppendedOnceThoughItIsAppendedAgain) {
  const TemporaryFolder folder;
  GrowingFile file(folder.file("log"));
  file.append("on disk.");
  file.sync();
  file.append("not yet.");
  {
    const FailingSync fault;
    EXPECT_THROW(file.sync(), std::runtime_error);
  }
  EXPECT_EQ(file.size(), 8u);
  file.append("not yet.");
  file.sync();
  EXPECT_EQ(textOf(folder.file("log")), "on disk.not yet.");
}

TEST(GrowingFile, APieceThatDoesNotFitLeavesNoTraceAndCanBeAppendedLater) {
  const TemporaryFolder folder;
  GrowingFile file(folder.file("log"));
  file.append("whole.");
  const std::string large(1000, 'x');
  {
    const LargestFile limit(100);
    try {
      file.append(large);
      FAIL() << "wrote beyond the limit";
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(contains(error.what(), folder.file("log"))) << error.what();
      EXPECT_TRUE(contains(error.what(), strerror(EFBIG))) << error.what();
    }
    EXPECT_EQ(textOf(folder.file("log")), "whole.");
  }
  file.append(large);
  file.sync();
  EXPECT_EQ(textOf(folder.file("log")), "whole." + large);
}

TEST(GrowingFile, NoticesThatItWasRemoved) {
  const TemporaryFolder folder;
  GrowingFile file(folder.file("log"));
  EXPECT_FALSE(file.removed());
  std::filesystem::remove(folder.file("log"));
  EXPECT_TRUE(file.removed());
  EXPECT_THROW(file.append("into nowhere"), std::runtime_error);
}

TEST(GrowingFile, DoesNotTouchAFileThatIsThere) {
  const TemporaryFolder folder;
  EXPECT_THROW(GrowingFile(folder.with("log", "of another")), std::runtime_error);
  EXPECT_EQ(textOf(folder.file("log")), "of another");
}

}  // namespace
}  // namespace revisit_slam
