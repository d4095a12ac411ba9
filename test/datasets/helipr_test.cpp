// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>

#include "datasets/dataset_writers.h"
#include "datasets/simulated_scans.h"
#include "revisit_slam/datasets/open_dataset.h"
#include "support/contains.h"

namespace revisit_slam {
namespace {

struct Sensor {
  const char *dataset, *folder, *simulated, *description;
};

void PrintTo(const Sensor& sensor, std::ostream* out) {
  *out << sensor.dataset;
}

class HeliprSensors : public ::testing::TestWithParam<Sensor> {};

TEST_P(HeliprSensors, AreReadWithTheirPointTimes) {
  const TemporaryFolder folder;
  const std::string sensor = GetParam().folder;
  const auto simulated = simulatedScans(GetParam().simulated, 100);
  writeHelipr(folder, sensor, simulated);
  const auto scans = openDataset(GetParam().dataset, folder.file(""));
  ASSERT_EQ(scans->size(), simulated.size());
  for (std::size_t i = 0; i < simulated.size(); ++i) expectDeskewable(scans->read(i), simulated[i]);
  PointReader reader({});
  readWith(reader, scans->read(0));
  EXPECT_TRUE(contains(reader.description(), GetParam().description));
  EXPECT_EQ(scans->read(0).frame_id, scans->frame());
}

INSTANTIATE_TEST_SUITE_P(
    All, HeliprSensors,
    ::testing::Values(
        Sensor{"helipr-ouster", "Ouster", "spinning-64", "field 't', uint32, relative ns"},
        Sensor{"helipr-avia", "Avia", "rosette", "field 'offset_time', uint32, relative ns"},
        Sensor{"helipr-aeva", "Aeva", "narrow", "field 'time_offset_ns', int32, relative ns"},
        Sensor{"helipr-velodyne", "Velodyne", "spinning-16", "field 'time', float32, relative s"}));

TEST(Helipr, FieldsBehindTheTimeAreInPlace) {
  const TemporaryFolder folder;
  const auto simulated = simulatedScans("spinning-64", 100);
  writeHelipr(folder, "Ouster", simulated);
  const PointCloud cloud = openDataset("helipr-ouster", folder.file(""))->read(0);
  ASSERT_EQ(cloud.fields.size(), 8u);
  const PointField& ring = cloud.fields[6];
  EXPECT_EQ(ring.name, "ring");
  EXPECT_EQ(ring.type, NumberType::uint16);
  for (std::size_t i = 0; i < simulated[0].rings.size(); ++i) {
    std::uint16_t value;
    std::memcpy(&value, &cloud.data[i * cloud.point_step + ring.offset], sizeof(value));
    ASSERT_EQ(value, simulated[0].rings[i]) << i;
  }
}

TEST(Helipr, EarlyScansOfAevaHaveNoIntensity) {
  const TemporaryFolder folder;
  auto simulated = simulatedScans("narrow", 100);
  simulated.resize(2);
  simulated[0].first = {1691936557946849179};
  simulated[1].first = {1691936557946849180};
  for (int i = 0; i < 2; ++i) {
    simulated[i].scan.stamp = {simulated[i].first.nanoseconds + simulated[i].nanoseconds.back()};
    heliprBytes("Aeva", simulated[i], i == 1)
        .save(folder.file("LiDAR/Aeva/" + stampName(simulated[i].first) + ".bin"));
  }
  const auto scans = openDataset("helipr-aeva", folder.file(""));
  expectDeskewable(scans->read(0), simulated[0]);
  expectDeskewable(scans->read(1), simulated[1]);
  EXPECT_EQ(scans->read(0).fields.back().name, "line_index");
  EXPECT_EQ(scans->read(1).fields.back().name, "intensity");
}

TEST(Helipr, GroundTruthIsThatOfTheSensor) {
  const TemporaryFolder folder;
  writeHelipr(folder, "Avia", simulatedScans("rosette", 50));
  EXPECT_FALSE(openDataset("helipr-avia", folder.file(""))->groundTruth());
  ByteFile()
      .text("1700000000500000001 1 2 3 0 0 0.6 0.8\n")
      .save(folder.file("LiDAR_GT/Avia_gt.txt"));
  const auto truth = openDataset("helipr-avia", folder.file(""))->groundTruth();
  ASSERT_TRUE(truth);
  ASSERT_EQ(truth->size(), 1u);
  EXPECT_EQ(truth->front().stamp.nanoseconds, 1700000000500000001);
  expectPose(truth->front().T_world_base, {Eigen::Quaterniond(0.8, 0, 0, 0.6), {1, 2, 3}});
}

}  // namespace
}  // namespace revisit_slam
