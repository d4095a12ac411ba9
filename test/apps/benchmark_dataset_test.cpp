// SPDX-License-Identifier: MIT
// scripts/benchmark on folders in the layouts of public datasets, several recordings of a place.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "datasets/dataset_writers.h"
#include "datasets/simulated_scans.h"
#include "support/child_process.h"
#include "support/contains.h"

namespace revisit_slam {
namespace {

namespace fs = std::filesystem;

class BenchmarkDataset : public testing::Test {
 protected:
  /// Runs it without any peer, which would have to be installed.
  int run(const std::string& dataset, const std::vector<std::string>& options = {}) {
    std::vector<std::string> words{"/usr/bin/python3",   "scripts/benchmark", "--out",
                                   folder_.file("out"),  "--dataset",         dataset,
                                   folder_.file("data"), "--average"};
    words.insert(words.end(), options.begin(), options.end());
    ChildProcess process(words);
    const int status = process.wait(120.0);
    output_ = process.output();
    return status;
  }

  /// Makes a folder in a layout the recording `name` of the dataset.
  void record(const TemporaryFolder& layout, const std::string& name) {
    fs::create_directories(fs::path(folder_.file("data/" + name)).parent_path());
    fs::copy(layout.file(""), folder_.file("data/" + name), fs::copy_options::recursive);
  }

  std::string page() const { return textOf(folder_.file("out/benchmark.md")); }
  nlohmann::json results() const {
    return nlohmann::json::parse(textOf(folder_.file("out/benchmark.json")));
  }

  const std::vector<SimulatedScan> scans_ = simulatedScans("spinning-64", 1024);
  TemporaryFolder folder_;
  std::string output_;
};

void writeHeliprTruth(const TemporaryFolder& folder, const std::string& sensor,
                      const std::vector<SimulatedScan>& scans) {
  ByteFile file;
  for (std::size_t i = 0; i < scans.size(); ++i)
    file.text(std::to_string(scans[i].scan.stamp.nanoseconds) + " " + std::to_string(0.9 * i) +
              " 0 0 0 0 0 1\n");
  file.save(folder.file("LiDAR_GT/" + sensor + "_gt.txt"));
}

TEST_F(BenchmarkDataset, averagesTheRecordingsOfAPlaceBesideThePaper) {
  TemporaryFolder layout;
  writeHelipr(layout, "Ouster", scans_);
  writeHeliprTruth(layout, "Ouster", scans_);
  for (const char* name : {"Town01", "Town02"}) record(layout, name);
  ASSERT_EQ(run("helipr", {"--systems", "revisit_slam,paper"}), 0) << output_;
  EXPECT_TRUE(contains(page(), "| HeLiPR | Town Ouster |")) << page();
  EXPECT_TRUE(contains(page(), "| KISS-SLAM | 1.99 / 0.21 |"));
  EXPECT_TRUE(contains(page(), "| recordings averaged | 2 |"));
  const nlohmann::json drives = results()["sequences"];
  double sum = 0.0;
  for (const char* name : {"town01-ouster", "town02-ouster"})
    sum += drives[name]["results"]["revisit_slam"]["ate_m"].get<double>();
  char row[64];
  std::snprintf(row, sizeof(row), "| **revisit_slam**, measured here | %.2f / – |", sum / 2.0);
  EXPECT_TRUE(contains(page(), row)) << row << "\n" << page();
}

TEST_F(BenchmarkDataset, takesATrajectoryMadeElsewhereAsARow) {
  TemporaryFolder layout;
  writeHelipr(layout, "Avia", scans_);
  writeHeliprTruth(layout, "Avia", scans_);
  record(layout, "Bridge01");
  ASSERT_EQ(run("helipr", {"--systems", "revisit_slam"}), 0) << output_;
  fs::create_directories(folder_.file("mulls"));
  fs::copy(folder_.file("out/bridge01-avia/gt.tum"), folder_.file("mulls/bridge01-avia.tum"));
  ASSERT_EQ(
      run("helipr", {"--systems", "mulls", "--trajectories", "mulls=" + folder_.file("mulls")}), 0)
      << output_;
  const nlohmann::json rows = results()["sequences"]["bridge01-avia"]["results"];
  EXPECT_LT(rows["mulls"]["ate_m"], 1e-6);
  EXPECT_TRUE(rows.contains("revisit_slam"));
  EXPECT_TRUE(contains(page(), "| mulls (given), measured here | 0.00 / – |")) << page();
}

TEST_F(BenchmarkDataset, findsTheRecordingsOfEachDataset) {
  const auto placeOf = [&](const std::string& dataset, const std::string& recording,
                           const auto& write) {
    fs::remove_all(folder_.file("data"));
    fs::remove_all(folder_.file("out"));
    TemporaryFolder layout;
    write(layout);
    record(layout, recording);
    EXPECT_EQ(run(dataset, {"--systems", "revisit_slam"}), 0) << output_;
    const nlohmann::json drives = results()["sequences"];
    EXPECT_EQ(drives.size(), 1u);
    return drives.begin().value()["group"].get<std::string>();
  };
  EXPECT_EQ(placeOf("mulran", "KAIST02", [&](auto& folder) { writeMulran(folder, scans_); }),
            "KAIST");
  EXPECT_EQ(placeOf("apollo", "TestData/ColumbiaPark/2018-09-21/4",
                    [&](auto& folder) { writeApollo(folder, scans_); }),
            "CP");
  EXPECT_EQ(placeOf("newer_college", "01_short_experiment",
                    [&](auto& folder) { writeNewerCollege(folder, scans_); }),
            "01 short");
  EXPECT_EQ(placeOf("kitti", "kitti", [&](auto& folder) { writeKittiOdometry(folder, scans_); }),
            "KITTI 04");
}

TEST_F(BenchmarkDataset, saysWhatIsWrongWithItsArguments) {
  EXPECT_NE(run("nuscenes"), 0);
  EXPECT_TRUE(contains(output_, "choose from helipr, mulran, apollo")) << output_;
  EXPECT_NE(run("mulran"), 0);
  EXPECT_TRUE(contains(output_, "no folder")) << output_;
  fs::create_directories(folder_.file("data/empty"));
  EXPECT_NE(run("mulran"), 0);
  EXPECT_TRUE(contains(output_, "no recording of it in")) << output_;
}

}  // namespace
}  // namespace revisit_slam
