// SPDX-License-Identifier: MIT
#include "revisit_slam/io/file_name.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(FileName, IsThatOfTheOpenFileUntilItIsRemovedOrGivenToAnother) {
  const TemporaryFolder folder;
  const std::string path = folder.with("log", "ours");
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  EXPECT_TRUE(hasName(file, path));
  EXPECT_FALSE(hasName(file, folder.with("other", "ours")));
  std::remove(path.c_str());
  EXPECT_FALSE(hasName(file, path));
  folder.with("log", "ours");
  EXPECT_FALSE(hasName(file, path));
  ::close(file);
}

}  // namespace
}  // namespace revisit_slam
