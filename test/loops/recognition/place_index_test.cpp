// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_index.h"

#include <gtest/gtest.h>

#include "alike_places.h"
#include "support/threads.h"

namespace revisit_slam {
namespace {

class PlaceIndexTest : public testing::Test {
 protected:
  PlaceIndexTest() {
    for (unsigned place = 0; place < 200; ++place) features_.push_back(places_.place(place));
    for (const PlaceFeatures& features : features_) pointers_.push_back(&features);
  }

  std::vector<std::size_t> similar(const PlaceIndex& index, const PlaceFeatures& query,
                                   std::size_t count, std::size_t excluded_begin = 0,
                                   std::size_t excluded_end = 0) const {
    PlaceIndex::Lookup lookup(index);
    std::vector<std::size_t> places;
    for (const auto& vote : index.similar(query, excluded_begin, excluded_end, count, lookup))
      places.push_back(vote.place);
    return places;
  }

  AlikePlaces places_;
  std::vector<PlaceFeatures> features_;
  std::vector<const PlaceFeatures*> pointers_;
};

TEST_F(PlaceIndexTest, NamesThePlaceThatIsSeenAgainFirst) {
  const PlaceIndex index(pointers_, {});
  for (unsigned place = 0; place < 200; place += 10) {
    const auto found = similar(index, places_.seenAgain(place, 0.3), 5);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front(), place);
    EXPECT_LE(found.size(), 5u);
  }
}

TEST_F(PlaceIndexTest, LeavesOutThePlacesOfItsOwnSession) {
  const PlaceIndex index(pointers_, {});
  const PlaceFeatures query = places_.seenAgain(50, 0.3);
  for (const std::size_t place : similar(index, query, 200, 40, 60))
    EXPECT_TRUE(place < 40 || place >= 60) << place;
}

/// A bucket that all share gives each entry the same chance.
TEST_F(PlaceIndexTest, HundredsOfEqualPlacesAreAllMet) {
  const PlaceFeatures same = places_.place(0);
  const std::vector<const PlaceFeatures*> equal(300, &same);
  PlaceIndexConfig config;
  config.largest_bucket = 8;
  EXPECT_GT(similar(PlaceIndex(equal, config), same, 300).size(), 250u);
}

TEST_F(PlaceIndexTest, IsTheSameForAnyNumberOfThreads) {
  const auto found = [&](int threads) {
    std::vector<std::size_t> all;
    tbb::task_arena(threads).execute([&] {
      const PlaceIndex index(pointers_, {});
      for (unsigned place = 0; place < 200; place += 20)
        for (const std::size_t other : similar(index, places_.seenAgain(place, 0.1), 20))
          all.push_back(other);
    });
    return all;
  };
  EXPECT_EQ(found(1), found(3));
}

}  // namespace
}  // namespace revisit_slam
