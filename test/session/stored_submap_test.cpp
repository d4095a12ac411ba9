// SPDX-License-Identifier: MIT
#include "revisit_slam/session/stored_submap.h"

#include <gtest/gtest.h>

#include <limits>

#include "session/session_fixtures.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

const std::set<SubmapRecord> kAll{SubmapRecord::trajectory, SubmapRecord::points,
                                  SubmapRecord::normals,    SubmapRecord::detail,
                                  SubmapRecord::occupancy,  SubmapRecord::sightings,
                                  SubmapRecord::intensities};

TEST(StoredSubmap, IsReadAsItWas) {
  const TemporaryFolder folder;
  const MapUpdatePtr update = StreetDrive::get().updates.at(1);
  const MapUpdate read = readSubmap(folder.with("a.rsm", encodeSubmap(*update)), kAll);
  EXPECT_EQ(read.submap->id, update->submap->id);
  EXPECT_EQ(read.submap->first_scan, update->submap->first_scan);
  EXPECT_EQ(read.submap->travelled_end, update->submap->travelled_end);
  EXPECT_EQ(read.submap->stamps, update->submap->stamps);
  EXPECT_EQ(read.submap->points, update->submap->points);
  EXPECT_EQ(read.submap->normals, update->submap->normals);
  EXPECT_EQ(read.detail_submap, update->detail_submap);
  EXPECT_EQ(read.sightings.lasted, update->sightings.lasted);
  EXPECT_EQ(encodeSubmap(read), encodeSubmap(*update));  // poses and occupancy too
}

TEST(StoredSubmap, HasTheIntensitiesOfItsDetail) {
  const TemporaryFolder folder;
  MapUpdate update = *StreetDrive::get().updates.at(1);
  for (std::size_t i = 0; i < update.detail_submap.size(); ++i)
    update.intensities.push_back(static_cast<float>(i % 256));
  const MapUpdate read = readSubmap(folder.with("a.rsm", encodeSubmap(update)), kAll);
  EXPECT_EQ(read.intensities, update.intensities);
  EXPECT_EQ(encodeSubmap(read), encodeSubmap(update));
}

/// With right checksums: nothing but the contents tells.
TEST(StoredSubmap, ContentsThatCannotBeAreRefusedWithTheFile) {
  const TemporaryFolder folder;
  MapUpdate nowhere = *StreetDrive::get().updates.at(1);
  nowhere.detail_submap[0].x() = std::numeric_limits<float>::infinity();
  MapUpdate far = *StreetDrive::get().updates.at(1);
  auto occupancy = std::make_shared<SubmapOccupancy>(0.5);
  BlockCounts counts;
  counts.set(0, 1, 0);
  occupancy->append({2'000'000'000, 0, 0}, counts);
  far.occupancy = occupancy;
  MapUpdate others = *StreetDrive::get().updates.at(1);
  others.sightings.lasted.pop_back();
  MapUpdate brighter = *StreetDrive::get().updates.at(1);
  brighter.intensities.resize(brighter.detail_submap.size() + 1);
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  MapUpdate unplaced = *StreetDrive::get().updates.at(1);
  unplaced.detail_submap[0].x() = none;
  MapUpdate unlit = *StreetDrive::get().updates.at(1);
  unlit.intensities.assign(unlit.detail_submap.size(), none);
  const auto with_normals = [&](auto change) {
    MapUpdate update = *StreetDrive::get().updates.at(1);
    auto submap = std::make_shared<Submap>(*update.submap);
    change(submap->normals);
    update.submap = submap;
    return update;
  };
  const MapUpdate undirected = with_normals([&](Points& normals) { normals[0].y() = none; });
  MapUpdate carried = *StreetDrive::get().updates.at(1);
  auto far_scan = std::make_shared<Submap>(*carried.submap);
  far_scan->T_submap_scan.back().translation.z() = 9e6;
  carried.submap = far_scan;
  MapUpdate fine = *StreetDrive::get().updates.at(1);
  fine.occupancy = std::make_shared<SubmapOccupancy>(1e-300);
  const MapUpdate fewer = with_normals([](Points& normals) { normals.pop_back(); });
  for (const MapUpdate& update :
       {nowhere, far, others, brighter, unplaced, unlit, undirected, fewer, carried, fine})
    try {
      readSubmap(folder.with("a.rsm", encodeSubmap(update)), kAll);
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(contains(error.what(), "a.rsm' cannot be used")) << error.what();
    }
}

TEST(StoredSubmap, OnlyWhatIsWantedIsRead) {
  const TemporaryFolder folder;
  const std::string path = folder.with("a.rsm", encodeSubmap(*StreetDrive::get().updates.at(1)));
  const MapUpdate read = readSubmap(path, {SubmapRecord::normals});
  EXPECT_TRUE(read.detail_submap.empty() && read.submap->points.empty() && !read.occupancy);
  EXPECT_FALSE(read.submap->normals.empty());
}

TEST(StoredSubmap, CutOrFlippedItIsRefusedWithTheReason) {
  const TemporaryFolder folder;
  const std::string whole = encodeSubmap(*StreetDrive::get().updates.at(1));
  for (std::size_t i = 20; i < whole.size(); i += whole.size() / 10) {
    EXPECT_THROW(readSubmap(folder.with("cut.rsm", whole.substr(0, i)), kAll), std::runtime_error);
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 1);
    try {
      readSubmap(folder.with("flipped.rsm", flipped), kAll);
      FAIL() << "byte " << i;
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(contains(error.what(), "flipped.rsm")) << error.what();
    }
  }
}

}  // namespace
}  // namespace revisit_slam
