// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/submap_library.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

namespace revisit_slam {
namespace {

constexpr std::size_t kPoints = 100;
constexpr std::size_t kBytes = 2 * kPoints * sizeof(Eigen::Vector3f);  // of one submap

class SubmapLibraryTest : public testing::Test {
 protected:
  static SubmapPtr submap(std::uint32_t id) {
    auto submap = std::make_shared<Submap>();
    submap->id.value = id;
    submap->T_submap_scan.resize(3);
    submap->stamps.resize(3);
    submap->points.assign(kPoints, Eigen::Vector3f::Constant(static_cast<float>(id)));
    submap->normals.assign(kPoints, Eigen::Vector3f::UnitZ());
    return submap;
  }
  void addAll() {
    for (std::uint32_t id = 0; id < 5; ++id) library_.add(submap(id), nullptr);
  }
  void store(std::uint32_t id) {
    library_.noteStored({id}, [this, id] {
      ++reads_;
      return *submap(id);
    });
  }

  SubmapLibrary library_{2 * kBytes};
  int reads_ = 0;
};

TEST_F(SubmapLibraryTest, ReadsWhatAnotherOneCanRead) {
  const auto known = std::make_shared<SubmapLibrary>(0);
  for (const std::uint32_t id : {0u, 1u, 2u, 3u}) known->add(submap(id), nullptr);
  for (const std::uint32_t id : {1u, 2u, 3u}) known->noteStored({id}, [id] { return *submap(id); });
  SubmapLibrary other(kBytes);
  other.addStored(known);
  EXPECT_EQ(other.bytes(), 0u);
  EXPECT_FALSE(other.has({0}));
  EXPECT_EQ(other.points({1}), kPoints);
  EXPECT_TRUE(other.light({1})->points.empty());
  for (const std::uint32_t id : {1u, 3u}) EXPECT_EQ(other.whole({id})->points, submap(id)->points);
  EXPECT_EQ(other.bytes(), kBytes);
  // From where it lies now.
  known->noteStored({2}, [this] {
    ++reads_;
    return *submap(2);
  });
  EXPECT_EQ(other.whole({2})->points, submap(2)->points);
  EXPECT_EQ(reads_, 1);
}

TEST_F(SubmapLibraryTest, WhatIsNotOnDiskStays) {
  addAll();
  EXPECT_EQ(library_.bytes(), 5 * kBytes);
  for (std::uint32_t id = 0; id < 5; ++id) EXPECT_NE(library_.inMemory({id}), nullptr);
}

TEST_F(SubmapLibraryTest, WhatIsOnDiskHasTheRoomThatIsStatedAndComesBack) {
  addAll();
  for (std::uint32_t id = 0; id < 5; ++id) store(id);
  EXPECT_EQ(library_.bytes(), 2 * kBytes);
  EXPECT_EQ(library_.inMemory({0}), nullptr);
  EXPECT_NE(library_.inMemory({4}), nullptr);
  EXPECT_EQ(library_.points({0}), kPoints);
  const SubmapPtr back = library_.whole({0});
  EXPECT_EQ(reads_, 1);
  EXPECT_EQ(back->points, submap(0)->points);
  EXPECT_EQ(back->normals, submap(0)->normals);
  EXPECT_EQ(back->T_submap_scan.size(), 3u);
  EXPECT_EQ(library_.bytes(), 2 * kBytes);
  EXPECT_EQ(library_.inMemory({3}), nullptr);  // 4 was used later
  EXPECT_EQ(library_.whole({0}), back);
  EXPECT_EQ(reads_, 1);
}

/// Else the stage that builds would wait for the disk.
TEST_F(SubmapLibraryTest, OthersAreAddedWhileOneIsRead) {
  addAll();
  library_.noteStored({0}, [this] {
    library_.add(submap(5), nullptr);
    return *submap(0);
  });
  for (std::uint32_t id = 1; id < 5; ++id) store(id);
  EXPECT_EQ(library_.whole({0})->points, submap(0)->points);
  EXPECT_NE(library_.inMemory({5}), nullptr);
}

TEST_F(SubmapLibraryTest, TheLightOnesHaveEverythingButPoints) {
  addAll();
  const SubmapPtr light = library_.light({2});
  EXPECT_EQ(light->id, SubmapId{2});
  EXPECT_TRUE(light->points.empty());
  EXPECT_TRUE(light->normals.empty());
  EXPECT_EQ(light->T_submap_scan.size(), 3u);
  EXPECT_FALSE(library_.has({7}));
  EXPECT_THROW(library_.light({7}), std::out_of_range);
}

TEST_F(SubmapLibraryTest, AFileThatIsAnotherOneIsRefusedAndNothingIsKeptOfIt) {
  addAll();
  library_.noteStored({0}, [] { return *submap(1); });
  for (std::uint32_t id = 1; id < 5; ++id) store(id);
  EXPECT_THROW(library_.whole({0}), std::runtime_error);
  EXPECT_EQ(library_.inMemory({0}), nullptr);
  EXPECT_EQ(library_.bytes(), 2 * kBytes);
}

}  // namespace
}  // namespace revisit_slam
