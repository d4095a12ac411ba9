// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/save_root.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

class SaveRoot : public testing::Test {
 protected:
  SaveRoot() {
    std::filesystem::create_directories(folder_.file("root/maps"));
    std::filesystem::create_directories(folder_.file("elsewhere"));
    live_.save_root = folder_.file("root");
    live_.folder = folder_.file("root/maps");
  }

  bool allows(const std::string& folder) const {
    try {
      requireBelowSaveRoot(live_, folder);
      return true;
    } catch (const std::runtime_error&) {
      return false;
    }
  }

  TemporaryFolder folder_;
  LiveConfig live_;
};

TEST_F(SaveRoot, IsLeftByNoPath) {
  EXPECT_TRUE(allows(""));
  EXPECT_TRUE(allows("relative"));
  EXPECT_TRUE(allows("../beside"));
  EXPECT_TRUE(allows(folder_.file("root/new/deeper")));
  EXPECT_TRUE(allows(folder_.file("root/new/../other")));
  EXPECT_FALSE(allows("../../elsewhere"));
  EXPECT_FALSE(allows(folder_.file("elsewhere")));
  EXPECT_FALSE(allows(folder_.file("root/../elsewhere")));
  EXPECT_FALSE(allows(folder_.file("root_of_others")));
  EXPECT_FALSE(allows("/proc/nowhere"));
}

TEST_F(SaveRoot, IsNotReplacedByAFolderBesideIt) {
  EXPECT_FALSE(allows(folder_.file("root")));
  EXPECT_FALSE(allows(folder_.file("root/")));
  EXPECT_FALSE(allows(".."));
  EXPECT_FALSE(allows("new/../.."));
}

TEST_F(SaveRoot, IsLeftByNoLink) {
  std::filesystem::create_directory_symlink(folder_.file("elsewhere"), folder_.file("root/link"));
  EXPECT_FALSE(allows(folder_.file("root/link")));
  EXPECT_FALSE(allows(folder_.file("root/link/new")));
  EXPECT_FALSE(allows("../link/new"));
}

TEST_F(SaveRoot, WithoutOneEverythingIsAllowed) {
  live_.save_root.clear();
  EXPECT_TRUE(allows("/proc/nowhere"));
}

}  // namespace
}  // namespace revisit_slam
