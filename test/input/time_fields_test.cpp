// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_fields.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

PointView viewWith(const std::vector<std::string>& names) {
  PointView view;
  for (const std::string& name : names) view.fields.push_back({name, NumberType::float32, 0});
  return view;
}

TEST(TimeFields, theNamesThatDriversUseAreFoundInAnyCase) {
  for (const char* name : {"t", "T", "time", "timestamp", "timestamps", "TimeStamp", "time_stamp",
                           "offset_time", "time_offset", "time_offset_ns", "timeoffset", "stamp"}) {
    const auto found = findTimeFields(viewWith({"x", "intensity", name}), "auto");
    ASSERT_EQ(found.size(), 1u) << name;
    EXPECT_EQ(found[0].name, name);
  }
  EXPECT_TRUE(findTimeFields(viewWith({"x", "y", "intensity", "ring", "tag"}), "auto").empty());
}

TEST(TimeFields, theLikelierNameComesFirst) {
  const auto found = findTimeFields(viewWith({"stamp", "timestamp", "t"}), "auto");
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].name, "t");
  EXPECT_EQ(found[2].name, "stamp");
}

TEST(TimeFields, aWantedFieldNeedsNoUsualName) {
  const PointView view = viewWith({"t", "laser_clock"});
  ASSERT_EQ(findTimeFields(view, "laser_clock").size(), 1u);
  EXPECT_TRUE(findTimeFields(view, "other").empty());
}

TEST(TimeFields, namesMayTellTheUnit) {
  EXPECT_EQ(unitInName("time_offset_ns"), TimeUnit::ns);
  EXPECT_EQ(unitInName("Stamp_US"), TimeUnit::us);
  EXPECT_EQ(unitInName("offset_msec"), TimeUnit::ms);
  EXPECT_FALSE(unitInName("t"));
}

}  // namespace
}  // namespace revisit_slam
