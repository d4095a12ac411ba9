// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_candidates.h"

#include <gtest/gtest.h>

#include "alike_places.h"
#include "support/threads.h"

namespace revisit_slam {
namespace {

/// Sessions of 10 places each; all sessions see the first three places, the rest is their own.
std::vector<PlaceView> sessions(unsigned count) {
  const AlikePlaces places;
  std::vector<PlaceView> views;
  for (unsigned session = 0; session < count; ++session)
    for (unsigned place = 0; place < 10; ++place) {
      const bool is_shared = place < 3;
      views.push_back(AlikePlaces::view(
          {place, SessionId{session}},
          is_shared ? (session == 0 ? places.place(place) : places.seenAgain(place, 0.5))
                    : places.place(1000 + 10 * session + place)));
    }
  return views;
}

std::vector<PlaceMatch> find(const std::vector<PlaceView>& views,
                             const PlaceCandidatesConfig& config) {
  return findPlaceCandidates(views, PlaceRecognitionConfig{}, config);
}

TEST(PlaceCandidates, AreThePlacesThatSessionsShare) {
  const auto matches = find(sessions(2), {});
  ASSERT_EQ(matches.size(), 3u);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(matches[i].source, (LocalMapId{i, SessionId{1}}));
    EXPECT_EQ(matches[i].target, (LocalMapId{i, SessionId{0}}));
    const double pixel = PlaceRecognitionConfig{}.image.resolution;
    EXPECT_NEAR(matches[i].T_target_source.translation.x(), -20.0 * pixel, pixel);
    EXPECT_NEAR(matches[i].T_target_source.translation.y(), 7.0 * pixel, pixel);
  }
}

TEST(PlaceCandidates, TheIndexLosesNothingHere) {
  PlaceCandidatesConfig config;
  const auto by_index = find(sessions(4), config);
  config.shortlist = 0;
  const auto exhaustive = find(sessions(4), config);
  ASSERT_EQ(by_index.size(), exhaustive.size());
  for (std::size_t i = 0; i < exhaustive.size(); ++i) {
    EXPECT_EQ(by_index[i].source, exhaustive[i].source);
    EXPECT_EQ(by_index[i].target, exhaustive[i].target);
    EXPECT_EQ(by_index[i].T_target_source.translation, exhaustive[i].T_target_source.translation);
  }
}

/// The work that follows does not grow with the square of the sessions that share a place.
TEST(PlaceCandidates, EachPlaceHasSoManyPartners) {
  PlaceCandidatesConfig config;
  config.partners = 2;
  const auto matches = find(sessions(12), config);
  EXPECT_LE(matches.size(), 12u * 3u * 2u);
  EXPECT_GE(matches.size(), 12u * 3u);
}

TEST(PlaceCandidates, AreTheSameForAnyNumberOfThreads) {
  const auto views = sessions(6);
  std::vector<PlaceMatch> one, three;
  tbb::task_arena(1).execute([&] { one = find(views, {}); });
  tbb::task_arena(3).execute([&] { three = find(views, {}); });
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].source, three[i].source);
    EXPECT_EQ(one[i].T_target_source.translation, three[i].T_target_source.translation);
  }
}

}  // namespace
}  // namespace revisit_slam
