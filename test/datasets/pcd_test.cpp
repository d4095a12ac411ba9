// SPDX-License-Identifier: MIT
// PCD files as Newer College has them, in every encoding, and damaged ones.
#include <gtest/gtest.h>

#include "datasets/pcd_file.h"
#include "revisit_slam/datasets/open_dataset.h"
#include "revisit_slam/input/point_reader.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

/// A dataset of one file, which can be read or the error in its place.
class OnePcd {
 public:
  PointCloud read(const ByteFile& file) const {
    file.save(folder_.file("ouster_scan/cloud_1700000000_5.pcd"));
    return openDataset("newer-college", folder_.file(""))->read(0);
  }
  std::string errorOf(const ByteFile& file) const {
    try {
      read(file);
      return "none";
    } catch (const DatasetError& error) {
      return error.what();
    }
  }
  std::string errorOf(const std::string& text) const { return errorOf(ByteFile().text(text)); }

 private:
  TemporaryFolder folder_;
};

TEST(Pcd, AsciiIsRead) {
  const auto cloud =
      OnePcd().read(ByteFile().text(pcdHeader("x y z ring", "4 4 4 2", "F F F U", 3, "ascii") +
                                    "1 2 3 60000\nnan nan nan 4\n-5.5 6e-1 7 -1\n"));
  const ScanReading reading = PointReader({}).read(viewOf(cloud), {cloud.stamp, "header", {}});
  ASSERT_TRUE(reading.scan) << reading.detail;
  EXPECT_EQ(reading.counts.not_finite, 1u);
  ASSERT_EQ(reading.scan->points.size(), 2u);
  EXPECT_EQ(reading.scan->points[1], Eigen::Vector3f(-5.5f, 0.6f, 7.f));
  std::uint16_t ring;
  std::memcpy(&ring, &cloud.data[12], sizeof(ring));
  EXPECT_EQ(ring, 60000);
}

TEST(Pcd, PaddingAndSeveralNumbersInAFieldAreSteppedOver) {
  ByteFile file;
  file.text(
      "# .PCD v.7\r\nVERSION .7\r\nFIELDS x _ y z\r\nSIZE 4 1 4 8\r\nTYPE F U F F\r\n"
      "COUNT 1 3 1 1\r\nWIDTH 1\r\nHEIGHT 1\r\nDATA binary\r\n");
  file.put(1.f).text("???").put(2.f).put(3.0);
  const auto cloud = OnePcd().read(file);
  EXPECT_EQ(cloud.point_step, 19u);
  EXPECT_EQ(cloud.fields.size(), 3u);
  const ScanReading reading = PointReader({}).read(viewOf(cloud), {cloud.stamp, "header", {}});
  ASSERT_TRUE(reading.scan) << reading.detail;
  EXPECT_EQ(reading.scan->points[0], Eigen::Vector3f(1, 2, 3));
}

TEST(Pcd, WrongCountIsAnError) {
  const auto with = [&](std::size_t count, const std::string& encoding) {
    ByteFile file;
    file.text(pcdHeader("x y z", "4 4 4", "F F F", count, encoding));
    return file.put(1.f).put(2.f).put(3.f);
  };
  const OnePcd pcd;
  EXPECT_EQ(pcd.errorOf(with(1, "binary")), "none");
  for (const std::size_t count : {2u, 1000000u, 67108864u})
    for (const char* encoding : {"binary", "ascii", "binary_compressed"})
      EXPECT_TRUE(contains(pcd.errorOf(with(count, encoding)), "cloud_1700000000_5.pcd"))
          << count << encoding;
  EXPECT_TRUE(contains(pcd.errorOf(with(0, "binary")), "no points"));
  EXPECT_TRUE(contains(pcd.errorOf(with(4294967295u, "binary")), "WIDTH"));
}

TEST(Pcd, GarbageInTheHeaderIsAnError) {
  const std::string head = "VERSION 0.7\n", tail = "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n";
  const std::string fields = "FIELDS x\n", size = "SIZE 4\n", type = "TYPE F\n";
  const std::string body(4, '\0');
  const OnePcd pcd;
  EXPECT_EQ(pcd.errorOf(head + fields + size + type + tail + body), "none");
  EXPECT_TRUE(contains(pcd.errorOf(head + tail + body), "FIELDS"));
  EXPECT_TRUE(contains(pcd.errorOf(head + fields + type + tail + body), "SIZE"));
  EXPECT_TRUE(contains(pcd.errorOf(head + fields + "SIZE -4\n" + type + tail + body), "SIZE"));
  EXPECT_TRUE(contains(pcd.errorOf(head + fields + "SIZE 3\n" + type + tail + body), "SIZE 3"));
  EXPECT_TRUE(contains(pcd.errorOf(head + fields + size + "TYPE Q\n" + tail + body), "TYPE Q"));
  const std::string all = head + fields + size + type, one = "WIDTH 1\nHEIGHT 1\n";
  EXPECT_TRUE(contains(pcd.errorOf(all + one + "POINTS 2\nDATA binary\n" + body), "POINTS"));
  EXPECT_TRUE(contains(pcd.errorOf(all + "WIDTH x\nHEIGHT 1\nDATA binary\n" + body), "WIDTH"));
  EXPECT_TRUE(contains(pcd.errorOf(all + one + "DATA zip\n" + body), "zip"));
  EXPECT_TRUE(contains(pcd.errorOf(std::string(100000, '\xff')), "no PCD header"));
}

TEST(Pcd, DamagedCompressionIsAnErrorWhereverItIs) {
  constexpr std::size_t points = 1000;
  std::string plain;
  for (std::size_t i = 0; i < 12 * points; ++i) plain += static_cast<char>(i % 37 * (i / 100 % 5));
  const ByteFile good = compressedPcd("x y z", "4 4 4", "F F F", points, plain);
  TemporaryFolder folder;
  good.save(folder.file("good"));
  const std::string bytes = textOf(folder.file("good"));
  const std::size_t body = bytes.find("compressed\n") + 11;
  const OnePcd pcd;
  EXPECT_EQ(pcd.errorOf(bytes), "none");
  for (const std::size_t size : {body, body + 3, body + 8, body + 100, bytes.size() - 1})
    EXPECT_TRUE(contains(pcd.errorOf(bytes.substr(0, size)), ".pcd'")) << size;
  for (std::size_t i = 0; i < 8; ++i) {  // both sizes
    std::string changed = bytes;
    changed[body + i] = static_cast<char>(changed[body + i] ^ 0x55);
    EXPECT_TRUE(contains(pcd.errorOf(changed), ".pcd'")) << i;
  }
  for (std::size_t i = body + 8; i < bytes.size(); i += 97) {  // never a crash
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0xff);
    pcd.errorOf(changed);
  }
}

}  // namespace
}  // namespace revisit_slam
