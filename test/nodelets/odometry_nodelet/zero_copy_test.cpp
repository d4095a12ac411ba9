// SPDX-License-Identifier: MIT
#include <cstdio>

#include "in_process_odometry.h"
#include "revisit_slam/ros/node/stage_topics.h"

namespace revisit_slam {
namespace {

using ZeroCopy = InProcessOdometry;
using ScanPtr = boost::shared_ptr<const OdometryOutput>;

TEST_F(ZeroCopy, theOdometryHoldsTheVeryCloudsThatWerePublished) {
  setParameter("frames/base", std::string("never_known"));
  load();
  const auto clouds = toClouds(driveInRoom(2));
  const CloudPtr in_work = publish(clouds[0]), waiting = publish(clouds[1]);
  ASSERT_TRUE(listener_.diagnoses("scans waiting", 1));

  // Once in this test, once in the odometry: a copy would not be counted.
  EXPECT_TRUE(becomesTrue([&] { return waiting.use_count() == 2; })) << waiting.use_count();
  EXPECT_TRUE(becomesTrue([&] { return in_work.use_count() == 2; })) << in_work.use_count();
  std::printf("clouds at %p and %p: owned by the test and by the odometry\n",
              static_cast<const void*>(in_work.get()), static_cast<const void*>(waiting.get()));
  loader_.clear();
  EXPECT_TRUE(becomesTrue([&] { return waiting.use_count() == 1; })) << waiting.use_count();
}

TEST_F(ZeroCopy, allSubscribersGetTheSameRegisteredScan) {
  // Written out to bytes and read again it would be no scan at all: such a topic cannot be read.
  std::mutex mutex;
  std::vector<ScanPtr> first, second;
  const auto keepIn = [&mutex](std::vector<ScanPtr>& kept) {
    return [&](const ScanPtr& scan) {
      const std::lock_guard<std::mutex> lock(mutex);
      kept.push_back(scan);
    };
  };
  ros::NodeHandle other_node(space_);
  const auto a = node_.subscribe<OdometryOutput>("registered_scan", 10, keepIn(first));
  const auto b = other_node.subscribe<OdometryOutput>("registered_scan", 10, keepIn(second));
  load();
  ASSERT_TRUE(becomesTrue([&] { return a.getNumPublishers() > 0 && b.getNumPublishers() > 0; }));
  for (const auto& cloud : toClouds(driveInRoom(3))) publish(cloud);
  const auto all_here = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return first.size() == 3 && second.size() == 3;
  };
  ASSERT_TRUE(becomesTrue(all_here));
  for (std::uint32_t i = 0; i < 3; ++i) {
    std::printf("registered scan %u at %p and %p\n", i, static_cast<const void*>(first[i].get()),
                static_cast<const void*>(second[i].get()));
    EXPECT_EQ(first[i].get(), second[i].get());
    EXPECT_EQ(first[i]->scan->id.value, i);
    EXPECT_FALSE(first[i]->scan->points_base.empty());
  }
}

}  // namespace
}  // namespace revisit_slam
