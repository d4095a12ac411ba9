// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/child_process.h"
#include "support/contains.h"
#include "support/scan_bag.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

class Doctor : public testing::Test {
 protected:
  Doctor() { writeScanBag(folder_.file("drive.bag"), toClouds(driveInRoom(12)), "/lidar"); }

  void expect(const std::vector<std::string>& options, int status,
              const std::vector<std::string>& texts) {
    std::vector<std::string> words{"env", "ROS_MASTER_URI=http://localhost:9",
                                   REVISIT_SLAM_DOCTOR_PROGRAM};
    words.insert(words.end(), options.begin(), options.end());
    ChildProcess process(words);
    EXPECT_EQ(process.wait(60.0), status) << process.output();
    for (const std::string& text : texts)
      EXPECT_TRUE(contains(process.output(), text)) << process.output();
  }

  TemporaryFolder folder_;
};

TEST_F(Doctor, EndsWithTheCommandThatMapsAGoodBag) {
  const std::string bag = folder_.file("drive.bag");
  expect({"--bag", bag}, 0,
         {"/lidar, 12 messages", "12 looked at, all can be used", "field 'time'", "0 faults",
          "offline --bag " + bag + " --points /lidar --base-frame none --out result"});
}

TEST_F(Doctor, SaysWhatToDoAboutEachFault) {
  expect({"--bag", folder_.file("driv.bag")}, 1,
         {"FAULT", "there is no file", "bags in its folder: " + folder_.file("drive.bag")});
  expect({"--bag", folder_.file("drive.bag"), "--points", "/points"}, 1,
         {"the bag has no topic '/points'", "one of: /lidar"});
  expect({"--bag", folder_.file("drive.bag"), "--set", "input/time_field=tiem"}, 1,
         {"'no field of the given name'", "-> set input/time_field to auto"});
  expect({"--bag", folder_.file("drive.bag"), "--folder", "/proc/maps"}, 1,
         {"live/folder is '/proc/maps', where nothing can be written", "-> choose another"});
}

TEST_F(Doctor, LooksAtEachOfSeveralSensors) {
  const std::string other = folder_.file("other.bag");
  writeScanBag(other, toClouds(driveInRoom(7)), "/rear");
  const std::vector<std::string> bags{"--bag", folder_.file("drive.bag"), "--bag", other};
  const auto with = [&](const std::string& topics) {
    std::vector<std::string> words = bags;
    words.insert(words.end(), {"--set", "input/topics=" + topics});
    return words;
  };
  expect(with("/lidar /rear"), 0,
         {"/lidar, 12 messages", "/rear, 7 messages", "7 looked at, all can be used",
          "--set input/topics=\"/lidar /rear\" --base-frame none"});
  expect(with("/lidar /front"), 1, {"/lidar, 12 messages", "the bag has no topic '/front'"});
}

TEST_F(Doctor, WithoutAMasterSaysHowToGetOne) {
  expect({"live", "--seconds", "0"}, 1, {"none answers at", "roscore"});
}

}  // namespace
}  // namespace revisit_slam
