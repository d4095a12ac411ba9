// SPDX-License-Identifier: MIT
// sensor_msgs/PointCloud2 and Livox's CustomMsg, from their bytes to a scan.
#include "readers.h"
#include "revisit_slam/ros/input/scan_reader.h"
#include "support/raw_messages.h"

namespace revisit_slam::fuzz {
namespace {

using Field = sensor_msgs::PointField;

/// Twice: what the first has decided is what the second meets.
void readTwice(const std::string& datatype, const std::string& md5sum, const std::string& bytes) {
  const RawMessage message{datatype, md5sum, "", {bytes.begin(), bytes.end()}, {}};
  ScanReader reader({});
  reader.read(message);
  reader.read(message);
}

template <typename Bytes>
std::string textOf(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

}  // namespace

void readPointCloud2(const std::string& bytes) {
  readTwice("sensor_msgs/PointCloud2", ros::message_traits::md5sum<sensor_msgs::PointCloud2>(),
            bytes);
}

Seeds seedsOfPointCloud2() {
  const auto points = sweep(0, 99.8e6, 24);
  Seeds seeds;
  for (auto& builder :
       {PointCloudBuilder().xyz(), PointCloudBuilder().xyz().field("t", Field::UINT32),
        PointCloudBuilder().xyz(Field::FLOAT64).field("time", Field::FLOAT64).bigEndian(),
        PointCloudBuilder().xyz().field("timestamp", Field::FLOAT64).rows(4, 8)})
    seeds.push_back(textOf(bytesOf(PointCloudBuilder(builder).build(points))));
  PointCloudBuilder rings = PointCloudBuilder().xyz(Field::INT16).field("ring", Field::UINT16);
  seeds.push_back(textOf(bytesOf(rings.build(sweep(0, 64, 24)))));
  return seeds;
}

void readLivox(const std::string& bytes) {
  readTwice("livox_ros_driver2/CustomMsg", livox_md5sum, bytes);
}

Seeds seedsOfLivox() {
  constexpr std::int64_t start = 1'700'000'000'000'000'000;
  return {textOf(livoxBytes(start, start, sweep(0, 99.8e6, 24))),
          textOf(livoxBytes(start, 1234, sweep(0, 99.8e6, 24)))};
}

}  // namespace revisit_slam::fuzz
