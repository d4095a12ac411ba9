// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/reading_buffer.h"

#include <gtest/gtest.h>

#include <string>

#include "revisit_slam/priors/motion_reading.h"

namespace revisit_slam {
namespace {

ImuReading at(double seconds) {
  ImuReading reading;
  reading.stamp = Stamp::fromSeconds(seconds);
  return reading;
}

TEST(ReadingBuffer, TakesEachInstantOnceAndInOrder) {
  ReadingBuffer<ImuReading> buffer;
  EXPECT_EQ(buffer.take(at(100.0)), nullptr);
  EXPECT_EQ(buffer.take(at(100.2)), nullptr);
  EXPECT_STREQ(buffer.take(at(100.2)), "duplicate stamp");
  EXPECT_STREQ(buffer.take(at(100.1)), "out of order");
  EXPECT_EQ(buffer.size(), 2u);
  EXPECT_TRUE(buffer.reaches(Stamp::fromSeconds(100.2)));
  EXPECT_FALSE(buffer.reaches(Stamp::fromSeconds(100.21)));
}

TEST(ReadingBuffer, FollowsAClockThatWasSetBack) {
  ReadingBuffer<ImuReading> buffer;
  buffer.take(at(100.0));
  EXPECT_EQ(buffer.take(at(50.0)), nullptr);
  EXPECT_EQ(buffer.take(at(50.1)), nullptr);
  EXPECT_EQ(buffer.size(), 2u);
}

TEST(ReadingBuffer, KeepsWhatIsAroundAnInstant) {
  ReadingBuffer<ImuReading> buffer;
  for (int i = 0; i < 5; ++i) buffer.take(at(100.0 + i));
  buffer.forgetBefore(Stamp::fromSeconds(102.5));
  EXPECT_EQ(buffer.begin()->stamp, Stamp::fromSeconds(102.0));
  EXPECT_EQ(buffer.at(Stamp::fromSeconds(102.5))->stamp, Stamp::fromSeconds(103.0));
  EXPECT_EQ(buffer.at(Stamp::fromSeconds(105.0)), buffer.end());
}

TEST(ReadingBuffer, IsBounded) {
  ReadingBuffer<ImuReading> buffer;
  for (int i = 0; i < 50'000; ++i) buffer.take(at(100.0 + 0.001 * i));
  EXPECT_LE(buffer.size(), 20'000u);
  EXPECT_TRUE(buffer.reaches(Stamp::fromSeconds(149.9)));
}

}  // namespace
}  // namespace revisit_slam
