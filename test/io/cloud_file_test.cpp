// SPDX-License-Identifier: MIT
#include "revisit_slam/io/cloud_file.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "revisit_slam/io/bytes.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

const Points kPoints{{1.0f, 2.0f, 3.0f}, {-4.5f, 0.0f, 1000.25f}, {7.0f, -8.0f, 9.0f}};
const std::vector<float> kIntensities{0.0f, 17.6f, 1e9f};  // of the first there is none

void write(const std::string& format, const std::string& path, bool with_intensities = false) {
  const auto stream = makeCloudStream(format, path, {with_intensities, 1.0f, {}});
  stream->write({kPoints[0]}, {});
  stream->write({kPoints[1], kPoints[2]}, {kIntensities[1], kIntensities[2]});
  stream->finish();
}

TEST(CloudFile, PlyIsWhatOthersRead) {
  const TemporaryFolder folder;
  write("ply", folder.file("map.ply"));
  pcl::PointCloud<pcl::PointXYZ> read;
  ASSERT_EQ(pcl::io::loadPLYFile(folder.file("map.ply"), read), 0);
  ASSERT_EQ(read.size(), kPoints.size());
  for (std::size_t i = 0; i < kPoints.size(); ++i) EXPECT_EQ(read[i].getVector3fMap(), kPoints[i]);
}

TEST(CloudFile, PlyHasIntensitiesWhereThereAreSome) {
  const TemporaryFolder folder;
  write("ply", folder.file("map.ply"), true);
  pcl::PointCloud<pcl::PointXYZI> read;
  ASSERT_EQ(pcl::io::loadPLYFile(folder.file("map.ply"), read), 0);
  ASSERT_EQ(read.size(), kPoints.size());
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    EXPECT_EQ(read[i].getVector3fMap(), kPoints[i]);
    EXPECT_EQ(read[i].intensity, kIntensities[i]);
  }
}

/// Offsets as in Tables 3 and 7 of the specification of LAS 1.2.
TEST(CloudFile, LasHasItsFieldsWhereTheSpecificationPutsThem) {
  const TemporaryFolder folder;
  write("las", folder.file("map.las"));
  const std::string bytes = textOf(folder.file("map.las"));
  const auto at = [&](std::size_t offset) { return bytes.substr(offset); };
  const auto number = [&](std::size_t offset) {
    const std::string rest = at(offset);
    return ByteReader(rest).get<std::uint32_t>();
  };
  const auto real = [&](std::size_t offset) {
    const std::string rest = at(offset);
    return ByteReader(rest).get<double>();
  };
  EXPECT_EQ(bytes.substr(0, 4), "LASF");
  EXPECT_EQ(bytes.substr(24, 2), "\x01\x02");
  EXPECT_EQ(number(96), 227u);    // offset to points
  EXPECT_EQ(bytes[104], 0);       // point format
  EXPECT_EQ(number(107), 3u);     // points
  EXPECT_EQ(real(131), 0.001);    // scale of x
  EXPECT_EQ(real(179), 7.0);      // largest x
  EXPECT_EQ(real(187), -4.5);     // smallest x
  EXPECT_EQ(real(211), 1000.25);  // largest z
  ASSERT_EQ(bytes.size(), 227u + 3u * 20u);
  const std::string second = at(227 + 20);
  EXPECT_EQ(ByteReader(second).get<std::int32_t>(), -4500);
  for (const auto& [point, intensity] : {std::pair(0, 0), std::pair(1, 18), std::pair(2, 65535)}) {
    const std::string rest = at(static_cast<std::size_t>(227 + 20 * point + 12));
    EXPECT_EQ(ByteReader(rest).get<std::uint16_t>(), intensity);
  }
}

/// The record of keys as in Sec. 2.4 of the specification of GeoTIFF 1.0.
TEST(CloudFile, LasNamesTheReferenceSystemOfItsFrame) {
  const TemporaryFolder folder;
  CloudFrame frame;
  frame.place = [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p + Eigen::Vector3d(691000.0, 5329000.0, 520.0));
  };
  frame.origin = {691000.0, 5329000.0, 0.0};
  frame.epsg = 32632;
  const auto stream = makeCloudStream("las", folder.file("map.las"), {false, 1.0f, frame});
  stream->write(kPoints, {});
  stream->finish();
  const std::string bytes = textOf(folder.file("map.las"));
  const auto read = [&](std::size_t offset, auto like) {
    const std::string rest = bytes.substr(offset);
    return ByteReader(rest).get<decltype(like)>();
  };
  const std::uint32_t points_at = read(96, std::uint32_t{});
  ASSERT_EQ(points_at, 227u + 54u + 5u * 8u);
  ASSERT_EQ(bytes.size(), points_at + 3u * 20u);
  EXPECT_EQ(read(100, std::uint32_t{}), 1u);  // records
  EXPECT_EQ(bytes.substr(227 + 2, 15), "LASF_Projection");
  EXPECT_EQ(read(227 + 18, std::uint16_t{}), 34735);
  EXPECT_EQ(read(227 + 20, std::uint16_t{}), 5 * 8);
  EXPECT_EQ(read(227 + 54 + 6, std::uint16_t{}), 4);  // keys
  EXPECT_EQ(read(227 + 54 + 16, std::uint16_t{}), 3072);
  EXPECT_EQ(read(227 + 54 + 22, std::uint16_t{}), 32632);
  EXPECT_EQ(read(155, double{}), 691000.0);  // offset of x
  EXPECT_EQ(read(163, double{}), 5329000.0);
  EXPECT_EQ(read(195, double{}), 5329002.0);  // largest y
  EXPECT_EQ(read(points_at, std::int32_t{}), 1000);
  EXPECT_EQ(read(points_at + 8, std::int32_t{}), 523000);
}

TEST(CloudFile, LasHasIntensitiesFrom0To1AsWholeNumbers) {
  const TemporaryFolder folder;
  const auto stream = makeCloudStream("las", folder.file("map.las"), {true, 65535.0f, {}});
  stream->write(kPoints, {0.0f, 0.5f, 1.0f});
  stream->finish();
  const std::string bytes = textOf(folder.file("map.las"));
  for (const auto& [point, intensity] :
       {std::pair(0, 0), std::pair(1, 32768), std::pair(2, 65535)}) {
    const std::string rest = bytes.substr(static_cast<std::size_t>(227 + 20 * point + 12));
    EXPECT_EQ(ByteReader(rest).get<std::uint16_t>(), intensity);
  }
}

TEST(CloudFile, OtherFormatsHavePointsInTheFrameToo) {
  const TemporaryFolder folder;
  CloudFrame frame;
  frame.place = [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p); };
  for (const char* format : {"ply", "pcd"}) {
    const auto stream = makeCloudStream(format, folder.file("map"), {true, 1.0f, frame});
    stream->write(kPoints, kIntensities);
    stream->finish();
    pcl::PointCloud<pcl::PointXYZI> read;
    ASSERT_EQ(format == std::string("ply") ? pcl::io::loadPLYFile(folder.file("map"), read)
                                           : pcl::io::loadPCDFile(folder.file("map"), read),
              0);
    ASSERT_EQ(read.size(), kPoints.size());
    for (std::size_t i = 0; i < kPoints.size(); ++i) {
      EXPECT_EQ(read[i].getVector3fMap(), -kPoints[i]);
      EXPECT_EQ(read[i].intensity, kIntensities[i]);
    }
  }
}

TEST(CloudFile, RefusesOtherFormatsAndSaysHowToGetThem) {
  EXPECT_THROW(requireCloudFormat("xyz"), std::invalid_argument);
  try {
    requireCloudFormat("laz");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("las"), std::string::npos);
  }
}

}  // namespace
}  // namespace revisit_slam
