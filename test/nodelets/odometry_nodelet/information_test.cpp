// SPDX-License-Identifier: MIT
#include <cstdio>
#include <map>

#include "in_process_odometry.h"
#include "revisit_slam/ros/node/stage_topics.h"

namespace revisit_slam {
namespace {

constexpr std::uint32_t kScans = 40;

/// Odometry and information in one process, and all that they publish.
class Information : public InProcessOdometry {
 protected:
  using RegisteredPtr = boost::shared_ptr<const OdometryOutput>;
  using InformedPtr = boost::shared_ptr<const InformedScan>;

  void loadBoth() {
    ros::param::set(space_ + "information/frames/base", std::string());
    ros::param::set(space_ + "information/mapping/enabled", false);  // no maps are waited for
    load();
    ASSERT_TRUE(loader_.load(space_ + "information", "revisit_slam/Information", {}, {}));
    registered_subscriber_ = node_.subscribe<OdometryOutput>(
        "registered_scan", 0, [this](const RegisteredPtr& scan) { keep(scan, registered_); });
    informed_subscriber_ = node_.subscribe<InformedScan>(
        "informed_scan", 0, [this](const InformedPtr& scan) { keep(scan, informed_); });
    odometry_subscriber_ = node_.subscribe<nav_msgs::Odometry>(
        "odometry", 0,
        [this](const nav_msgs::Odometry::ConstPtr& message) { keep(message, odometry_); });
    ASSERT_TRUE(becomesTrue([this] {
      return registered_subscriber_.getNumPublishers() > 0 &&
             informed_subscriber_.getNumPublishers() > 0 &&
             odometry_subscriber_.getNumPublishers() > 0;
    }));
  }

  ~Information() override {
    for (ros::Subscriber* subscriber :
         {&registered_subscriber_, &informed_subscriber_, &odometry_subscriber_})
      subscriber->shutdown();
    ros::param::del(space_ + "information");
  }

  template <typename Ptr>
  void keep(const Ptr& message, std::vector<Ptr>& kept) {
    const std::lock_guard<std::mutex> lock(mutex_);
    kept.push_back(message);
  }

  bool allHere(std::size_t count) {
    return becomesTrue([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return registered_.size() == count && informed_.size() == count && odometry_.size() == count;
    });
  }

  ros::Subscriber registered_subscriber_, informed_subscriber_, odometry_subscriber_;
  std::mutex mutex_;  // guards the next three
  std::vector<RegisteredPtr> registered_;
  std::vector<InformedPtr> informed_;
  std::vector<nav_msgs::Odometry::ConstPtr> odometry_;
};

TEST_F(Information, atThreeTimesRealTimeNoScanIsLostAndNoneIsCopied) {
  loadBoth();
  ros::WallRate three_times_real_time(30.0);
  for (const auto& cloud : toClouds(driveInRoom(kScans))) {
    publish(cloud);
    three_times_real_time.sleep();
  }
  ASSERT_TRUE(allHere(kScans));
  std::printf("registered scan at %p, within the informed scan at %p\n",
              static_cast<const void*>(registered_[1]->scan.get()),
              static_cast<const void*>(informed_[1]->scan.get()));
  for (std::uint32_t i = 0; i < kScans; ++i) {
    EXPECT_EQ(informed_[i]->scan.get(), registered_[i]->scan.get());
    EXPECT_EQ(informed_[i]->scan->id.value, i);
    EXPECT_EQ(informed_[i]->source,
              i == 0 ? InformationSource::identity : InformationSource::estimated);
  }
}

TEST_F(Information, theOdometryHasACovarianceThatGrows) {
  loadBoth();
  for (const auto& cloud : toClouds(driveInRoom(kScans))) publish(cloud);
  ASSERT_TRUE(allHere(kScans));
  const auto trace = [](const auto& covariance) {
    return covariance[0] + covariance[7] + covariance[14];
  };
  EXPECT_EQ(trace(odometry_.front()->pose.covariance), 0.0);  // where the odom frame is
  for (std::uint32_t i = 1; i < kScans; ++i) {
    EXPECT_GT(trace(odometry_[i]->pose.covariance), trace(odometry_[i - 1]->pose.covariance));
    EXPECT_GT(odometry_[i]->twist.covariance[0], 0.0);
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < row; ++column)
        EXPECT_NEAR(odometry_[i]->pose.covariance[6 * row + column],
                    odometry_[i]->pose.covariance[6 * column + row], 1e-12);
  }
}

TEST_F(Information, fallingBehindRepeatsTheLastMatrixAndMarksIt) {
  ros::param::set(space_ + "information/information/max_waiting", 1);
  loadBoth();
  ros::Publisher burst = node_.advertise<OdometryOutput>("registered_scan", 0);
  ASSERT_TRUE(becomesTrue([&] { return burst.getNumSubscribers() > 0; }));
  // Real problems first, so that there is work, then more than can wait.
  for (const auto& cloud : toClouds(driveInRoom(3))) publish(cloud);
  ASSERT_TRUE(allHere(3));
  std::vector<RegisteredPtr> many;
  for (std::uint32_t i = 0; i < 200; ++i) {
    auto scan = std::make_shared<RegisteredScan>(*registered_.back()->scan);
    scan->id.value = 3 + i;
    many.push_back(boost::make_shared<const OdometryOutput>(
        OdometryOutput{scan, registered_.back()->problem, {}}));
  }
  for (const RegisteredPtr& scan : many) burst.publish(scan);
  ASSERT_TRUE(allHere(203));
  std::map<InformationSource, int> counts;
  for (const InformedPtr& scan : informed_) ++counts[scan->source];
  EXPECT_GT(counts[InformationSource::repeated], 0);
  EXPECT_EQ(counts[InformationSource::identity], 1);
  for (const InformedPtr& scan : informed_) {
    if (scan->source != InformationSource::repeated) continue;
    EXPECT_GT(scan->estimate.information(0, 0), 1.0);  // an estimate, not the identity
  }
}

}  // namespace
}  // namespace revisit_slam
