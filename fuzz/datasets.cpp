// SPDX-License-Identifier: MIT
// The first byte chooses a file of a dataset, which the others are; all files beside it are good.
#include <deque>
#include <utility>

#include "readers.h"
#include "revisit_slam/datasets/open_dataset.h"
#include "revisit_slam/input/point_reader.h"
#include "scratch.h"

namespace revisit_slam::fuzz {
namespace {

struct Layout {
  const char* dataset;
  std::vector<std::pair<std::string, std::string>> files;
};

const std::vector<Layout>& layouts() {
  const std::string pose = " 0 0 0 0 0 0 1\n", matrix = "1 0 0 4 0 1 0 5 0 0 1 6\n";
  const std::string
      name = "1700000000500000000",
      date = "2011-09-26 13:02:25.",
      pcd =
          "VERSION 0.7\nFIELDS x y z t\nSIZE 4 4 4 4\nTYPE F F F U\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n"
          "DATA ascii\n1 2 3 4\n5 6 7 8\n";
  std::string oxts = "49 8 110 0 0 0";
  for (int i = 6; i < 30; ++i) oxts += " 0";
  static const std::vector<Layout> all{
      {"helipr-ouster",
       {{"LiDAR/Ouster/" + name + ".bin", std::string(52, 'a')},
        {"LiDAR_GT/Ouster_gt.txt", name + pose}}},
      {"helipr-avia", {{"LiDAR/Avia/" + name + ".bin", std::string(38, 'a')}}},
      {"helipr-aeva", {{"LiDAR/Aeva/" + name + ".bin", std::string(58, 'a')}}},
      {"helipr-velodyne", {{"LiDAR/Velodyne/" + name + ".bin", std::string(44, 'a')}}},
      {"mulran",
       {{"Ouster/" + name + ".bin", std::string(32, 'a')},
        {"global_pose.csv", name + ",1,0,0,4,0,1,0,5,0,0,1,6\n"}}},
      {"apollo", {{"pcds/1.pcd", pcd}, {"poses/gt_poses.txt", "1 1.5" + pose}}},
      {"newer-college",
       {{"raw_format/ouster_scan/cloud_1700000000_5.pcd", pcd},
        {"ground_truth/registered_poses.csv", "1700000000,5,0,0,0,0,0,0,1\n"}}},
      {"kitti-odometry",
       {{"velodyne/000000.bin", std::string(32, 'a')},
        {"times.txt", "0.000000e+00\n"},
        {"calib.txt", "P0: " + matrix + "Tr: " + matrix},
        {"poses.txt", matrix}}},
      {"kitti-raw",
       {{"velodyne_points/data/0000000000.bin", std::string(32, 'a')},
        {"velodyne_points/timestamps_start.txt", date + "100000001\n"},
        {"velodyne_points/timestamps_end.txt", date + "200000001\n"},
        {"oxts/timestamps.txt", date + "15\n"},
        {"oxts/data/0000000000.txt", oxts + "\n"},
        {"calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.8\n"}}},
  };
  return all;
}

/// A folder in which one file is to be written.
struct Place {
  const Layout* layout;
  std::size_t file;
  Scratch folder;
};

std::deque<Place>& places() {
  static std::deque<Place> all;
  if (!all.empty()) return all;
  for (const Layout& layout : layouts())
    for (std::size_t i = 0; i < layout.files.size(); ++i) {
      Place& place = all.emplace_back();
      place.layout = &layout;
      place.file = i;
      for (const auto& [name, good] : layout.files) place.folder.with(name, good);
    }
  return all;
}

}  // namespace

void readDatasets(const std::string& bytes) {
  if (bytes.empty()) return;
  const Place& place = places()[static_cast<unsigned char>(bytes[0]) % places().size()];
  place.folder.with(place.layout->files[place.file].first, bytes.substr(1));
  const auto scans = openDataset(place.layout->dataset, place.folder.file(""));
  PointReader reader({});
  for (std::size_t i = 0; i < scans->size(); ++i) {
    const PointCloud cloud = scans->read(i);
    reader.read(viewOf(cloud), {cloud.stamp, "header", {}});
  }
  scans->groundTruth();
}

Seeds seedsOfDatasets() {
  Seeds seeds;
  for (const Place& place : places())
    seeds.push_back(std::string(1, static_cast<char>(seeds.size())) +
                    place.layout->files[place.file].second);
  return seeds;
}

}  // namespace revisit_slam::fuzz
