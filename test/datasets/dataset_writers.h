// SPDX-License-Identifier: MIT
// Folders in the exact layout of each dataset. Each writer returns the paths of the scans.
#pragma once

#include <cstdio>

#include "datasets/pcd_file.h"
#include "datasets/simulated_scans.h"
#include "revisit_slam/io/trajectory.h"
#include "support/temporary_folder.h"

namespace revisit_slam {

using Paths = std::vector<std::string>;

inline std::string stampName(Stamp stamp) {
  return std::to_string(stamp.nanoseconds);
}

inline std::string padded(std::size_t number, int digits) {
  char text[32];
  std::snprintf(text, sizeof(text), "%0*zu", digits, number);
  return text;
}

inline ByteFile heliprBytes(const std::string& sensor, const SimulatedScan& scan,
                            bool aeva_intensity = true) {
  ByteFile file;
  for (std::size_t i = 0; i < scan.scan.points.size(); ++i) {
    const std::uint32_t ns = scan.nanoseconds[i];
    file.putPoint(scan.scan.points[i]);
    if (sensor == "Ouster")
      file.put<float>(7).put(ns).put<std::uint16_t>(8).put(scan.rings[i]).put<std::uint16_t>(9);
    if (sensor == "Avia")
      file.put<std::uint8_t>(7).put<std::uint8_t>(0x10).put<std::uint8_t>(3).put(ns);
    if (sensor == "Velodyne")
      file.put<float>(7).put(scan.rings[i]).put(static_cast<float>(ns * 1e-9));
    if (sensor == "Aeva") {
      file.put<float>(7).put<float>(-1.5).put(static_cast<std::int32_t>(ns));
      file.put<std::uint8_t>(4);
      if (aeva_intensity) file.put<float>(8);
    }
  }
  return file;
}

inline Paths writeHelipr(const TemporaryFolder& folder, const std::string& sensor,
                         const std::vector<SimulatedScan>& scans) {
  Paths paths;
  for (const SimulatedScan& scan : scans) {
    paths.push_back(folder.file("LiDAR/" + sensor + "/" + stampName(scan.first) + ".bin"));
    heliprBytes(sensor, scan).save(paths.back());
  }
  return paths;
}

/// Points of a scan of 64 beams and 1024 columns in the order of the Ouster's driver.
inline Points columnByColumn(const SimulatedScan& scan) {
  Points points(64 * 1024, Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < scan.scan.points.size(); ++i) {
    const std::size_t column = (std::size_t{scan.nanoseconds[i]} * 1024 + 50'000'000) / 100'000'000;
    points[column * 64 + scan.rings[i]] = scan.scan.points[i];
  }
  return points;
}

inline ByteFile xyziBytes(const Points& points) {
  ByteFile file;
  for (const Eigen::Vector3f& point : points) file.putPoint(point).put(0.5f);
  return file;
}

inline Paths writeMulran(const TemporaryFolder& folder, const std::vector<SimulatedScan>& scans) {
  Paths paths;
  for (const SimulatedScan& scan : scans) {
    paths.push_back(folder.file("Ouster/" + stampName(scan.first) + ".bin"));
    xyziBytes(columnByColumn(scan)).save(paths.back());
  }
  return paths;
}

inline Paths writeNewerCollege(const TemporaryFolder& folder,
                               const std::vector<SimulatedScan>& scans) {
  Paths paths;
  for (const SimulatedScan& scan : scans) {
    const std::int64_t stamp = scan.first.nanoseconds;
    const std::string seconds = std::to_string(stamp / 1'000'000'000);
    const std::string rest = padded(static_cast<std::size_t>(stamp % 1'000'000'000), 9);
    paths.push_back(folder.file("raw_format/ouster_scan/cloud_" + seconds + "_" + rest + ".pcd"));
    ByteFile file;
    file.text(pcdHeader("x y z intensity t reflectivity ring noise range", "4 4 4 4 4 2 1 2 4",
                        "F F F F U U U U U", scan.scan.points.size(), "binary"));
    for (std::size_t i = 0; i < scan.scan.points.size(); ++i)
      file.putPoint(scan.scan.points[i])
          .put(7.f)
          .put(scan.nanoseconds[i])
          .put<std::uint16_t>(8)
          .put(static_cast<std::uint8_t>(scan.rings[i]))
          .put<std::uint16_t>(9)
          .put<std::uint32_t>(10);
    file.save(paths.back());
  }
  return paths;
}

/// Compressed PCD with a field of times, which counts from 1970.
inline ByteFile apolloBytes(const SimulatedScan& scan) {
  const std::size_t count = scan.scan.points.size();
  std::string body;
  const auto put = [&](auto value) {
    body.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const Eigen::Vector3f& point : scan.scan.points) put(point[axis]);
  for (std::size_t i = 0; i < count; ++i) put(std::uint8_t{9});
  for (const std::uint32_t ns : scan.nanoseconds) put(scan.first.toSeconds() + ns * 1e-9);
  return compressedPcd("x y z intensity timestamp", "4 4 4 1 8", "F F F U F", count, body);
}

/// Scans 1, 2, … (not padded with zeros), at x = 1, 2, … metres.
inline Paths writeApollo(const TemporaryFolder& folder, const std::vector<SimulatedScan>& scans) {
  Paths paths;
  ByteFile poses;
  for (const SimulatedScan& scan : scans) {
    const std::string number = std::to_string(paths.size() + 1);
    paths.push_back(folder.file("pcds/" + number + ".pcd"));
    apolloBytes(scan).save(paths.back());
    poses.text(number + " " + stampText(scan.scan.stamp) + " " + number + " 0 0 0 0 0.6 0.8\n");
  }
  poses.save(folder.file("poses/gt_poses.txt"));
  return paths;
}

/// The sequence `data/sequences/04` below the folder.
inline Paths writeKittiOdometry(const TemporaryFolder& folder,
                                const std::vector<SimulatedScan>& scans) {
  const std::string sequence = folder.file("data/sequences/04/");
  Paths paths;
  for (const SimulatedScan& scan : scans) {
    paths.push_back(sequence + "velodyne/" + padded(paths.size(), 6) + ".bin");
    xyziBytes(scan.scan.points).save(paths.back());
  }
  ByteFile().text("0.000000e+00\n1.036224e-01\n2.072090e-01\n").save(sequence + "times.txt");
  return paths;
}

inline Paths writeKittiRaw(const TemporaryFolder& folder, const std::vector<SimulatedScan>& scans) {
  const std::string velodyne = folder.file("drive/velodyne_points/");
  Paths paths;
  for (const SimulatedScan& scan : scans) {
    paths.push_back(velodyne + "data/" + padded(paths.size(), 10) + ".bin");
    xyziBytes(scan.scan.points).save(paths.back());
  }
  const std::string minute = "2011-09-26 13:02:";
  ByteFile()
      .text(minute + "25.100000001\n" + minute + "25.200000002\n" + minute + "25.300000003\n")
      .save(velodyne + "timestamps_start.txt");
  ByteFile()
      .text(minute + "25.200000001\n" + minute + "25.300000002\n" + minute + "25.400000003\n")
      .save(velodyne + "timestamps_end.txt");
  return paths;
}

}  // namespace revisit_slam
