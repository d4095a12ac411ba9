// SPDX-License-Identifier: MIT
#include "revisit_slam/io/trajectory.h"

#include <gtest/gtest.h>

#include <sstream>

#include "support/random_numbers.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

constexpr std::int64_t kStamps[] = {
    0,  1,  999'999'999,  1'000'000'000,  1'700'000'000'123'456'789,
    -1, -5, -999'999'999, -1'000'000'001, -1'700'000'000'000'000'007};

Trajectory someTrajectory() {
  RandomNumbers random(1);
  Trajectory trajectory;
  for (const std::int64_t stamp : kStamps) trajectory.push_back({{stamp}, random.pose(1000.0)});
  return trajectory;
}

std::string messageOfReading(const std::string& path) {
  try {
    readTum(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Tum, LinesHaveNanosecondsAndTheScalarOfTheQuaternionLast) {
  std::ostringstream line;
  writeTumLine(line, {{-1'500'000'001}, {Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5), {1.25, -2, 3}}});
  EXPECT_EQ(line.str(),
            "-1.500000001 1.250000000 -2.000000000 3.000000000 "
            "-0.500000000000 0.500000000000 0.500000000000 0.500000000000\n");
}

TEST(Tum, ReadsBackStampsToTheNanosecondAndPoses) {
  const TemporaryFolder folder;
  const Trajectory written = someTrajectory();
  writeTum(folder.file("a.tum"), written);
  const Trajectory read = readTum(folder.file("a.tum"));
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].stamp.nanoseconds, written[i].stamp.nanoseconds);
    const Pose difference = read[i].T_world_base.inverse() * written[i].T_world_base;
    EXPECT_LT(difference.translation.norm(), 2e-9);
    EXPECT_LT(difference.angle(), 1e-11);
  }
}

TEST(Tum, ReadsStampsAsOthersWriteThem) {
  const TemporaryFolder folder;
  for (const auto& [text, nanoseconds] : std::vector<std::pair<std::string, std::int64_t>>{
           {"12", 12'000'000'000},
           {"12.", 12'000'000'000},
           {"-0.25", -250'000'000},
           {"1.5e3", 1'500'000'000'000},
           {"1700000000.123456", 1'700'000'000'123'456'000},
           {"0.1234567891", 123'456'789}}) {
    const auto read = readTum(folder.with("a.tum", text + " 1 2 3 0 0 0 1\n"));
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].stamp.nanoseconds, nanoseconds) << text;
  }
}

TEST(Tum, SkipsCommentsAndNormalizesRotations) {
  const TemporaryFolder folder;
  const auto read = readTum(folder.with("a.tum", "# stamp x y z\n\n1.0 1 2 3 0 0 2 0\n"));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].T_world_base.rotation.coeffs(), Eigen::Vector4d(0, 0, 1, 0));
  EXPECT_EQ(read[0].T_world_base.translation, Eigen::Vector3d(1, 2, 3));
}

TEST(Tum, NamesTheFileAndTheLineThatCannotBeRead) {
  const TemporaryFolder folder;
  for (const std::string bad : {"2.0 1 2 3 0 0 0", "2.0 1 2 x 0 0 0 1", "2.0",
                                "stamp x y z a b c d", "8999999999 1 2 3 0 0 0 1"}) {
    const auto path = folder.with("a.tum", "# comment\n1.0 1 2 3 0 0 0 1\n" + bad + "\n");
    const std::string message = messageOfReading(path);
    EXPECT_NE(message.find("line 3"), std::string::npos) << message;
    EXPECT_NE(message.find(path), std::string::npos) << message;
  }
  const std::string missing = folder.file("missing.tum");
  EXPECT_NE(messageOfReading(missing).find(missing), std::string::npos);
}

TEST(Tum, RefusesNumbersThatNobodyWrites) {
  const TemporaryFolder folder;
  for (const std::string& bad :
       {"1." + std::string(1 << 20, '0') + " 0 0 0 0 0 0 1", std::string("1 0 0 0 0 0 0 1e308"),
        std::string("1 0 0 0 1e308 1e308 1e308 1e308"), std::string("1e300 0 0 0 0 0 0 1")})
    EXPECT_THROW(readTum(folder.with("a.tum", bad + "\n")), std::runtime_error)
        << bad.substr(0, 40);
}

TEST(Tum, WritersNameTheFileThatTheyCannotWrite) {
  const std::string path = TemporaryFolder().file("gone/a.tum");
  EXPECT_THROW(writeTum(path, someTrajectory()), std::runtime_error);
  EXPECT_THROW(writeKitti(path, someTrajectory()), std::runtime_error);
}

TEST(Kitti, HasTheFirstThreeRowsOfEachMatrixOnALine) {
  const TemporaryFolder folder;
  const Trajectory trajectory = someTrajectory();
  writeKitti(folder.file("a.txt"), trajectory);
  std::istringstream lines(textOf(folder.file("a.txt")));
  std::string line;
  for (const StampedPose& pose : trajectory) {
    ASSERT_TRUE(std::getline(lines, line));
    std::istringstream numbers(line);
    Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
    for (int i = 0; i < 12; ++i) ASSERT_TRUE(numbers >> T(i / 4, i % 4));
    EXPECT_TRUE((numbers >> std::ws).eof());
    EXPECT_LT((T - pose.T_world_base.matrix()).norm(), 1e-8);
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(Kitti, ReadsBackPosesAndMakesRotationsOrthonormal) {
  const TemporaryFolder folder;
  const Trajectory written = someTrajectory();
  writeKitti(folder.file("a.txt"), written);
  const std::vector<Pose> read = readKitti(folder.file("a.txt"));
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    EXPECT_LT((read[i].matrix() - written[i].T_world_base.matrix()).norm(), 1e-8);
  const auto rounded = folder.with("b.txt", "0.0 -1.001 0 1 0.999 0 0 2 0 0 1.0 3\n");
  const Eigen::Matrix3d R = readKitti(rounded).at(0).rotationMatrix();
  EXPECT_LT((R - Eigen::Matrix3d(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()))).norm(),
            1e-12);
}

TEST(Kitti, RefusesLinesThatAreNoRigidMotion) {
  const TemporaryFolder folder;
  for (const std::string bad :
       {"1 0 0 0 0 1 0 0 0 0 1", "1 0 0 0 0 1 0 0 0 0 -1 0", "0 0 0 0 0 0 0 0 0 0 0 0"})
    EXPECT_THROW(readKitti(folder.with("a.txt", bad + "\n")), std::runtime_error) << bad;
  EXPECT_THROW(readKitti(folder.file("missing.txt")), std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
