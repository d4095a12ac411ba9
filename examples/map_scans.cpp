// SPDX-License-Identifier: MIT
// Maps a folder of scans without ROS (docs/api.md).
//   map_scans SCANS RESULT      SCANS: one .bin a scan, named in order: float x, y, z, intensity
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

#include "revisit_slam/slam/slam.h"

using namespace revisit_slam;

/// Prints what happens while the drive is mapped.
class Printer : public SlamObserver {
 public:
  void onScan(const InformedScan& informed, const StageTimes&) override {
    const RegisteredScan& scan = *informed.scan;
    std::cout << scan.id.value << ": " << scan.T_odom_base.translation.transpose() << " m, "
              << toString(informed.verdict) << "\n";
  }
  void onRejection(const std::string& reason) override { std::cerr << reason << "\n"; }
  void onCorrection(const MapCorrectionPtr& correction) override {  // in another thread
    std::cerr << correction->loops.size() << " loops, end moved by " << correction->moved_end
              << " m\n";
  }
};

Points readPoints(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Points points;
  for (float values[4]; stream.read(reinterpret_cast<char*>(values), sizeof values);)
    points.emplace_back(values[0], values[1], values[2]);
  return points;
}

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("usage: map_scans SCANS RESULT");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry);
  std::sort(files.begin(), files.end());

  SlamConfig config;
  config.frames.base.clear();  // the poses of the sensor
  config.odometry.max_range = 80.0;
  Printer printer;
  StagedExecutor executor(config.background);  // loops and graph in a thread of their own
  SessionTarget target;
  target.folder = argv[2];
  Slam slam(config, printer, executor, [&](SessionId, Stamp) { return target; });

  Stamp stamp = Stamp::fromSeconds(1.7e9);
  for (const auto& file : files) {
    ScanReading reading;
    reading.scan.emplace();
    reading.scan->stamp = stamp;
    reading.scan->points = readPoints(file);  // without times: not deskewed
    slam.insert(std::move(reading));
    stamp = stamp.plusSeconds(0.1);
  }
  slam.finish();
  if (!slam.session()) throw std::runtime_error("no scan could be used");
  for (const std::string& problem : slam.session()->saveOwn()) std::cerr << problem << "\n";
  std::cout << "the map is in " << slam.session()->folder() << "\n";
} catch (const std::exception& error) {
  std::cerr << "map_scans: " << error.what() << "\n";
  return 1;
}
