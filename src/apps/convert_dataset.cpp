// SPDX-License-Identifier: MIT
// Writes a folder of a public dataset as a bag, with its ground truth beside it.
#include <rosbag/bag.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "revisit_slam/datasets/open_dataset.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/ros/input/point_fields.h"
#include "revisit_slam/util/progress.h"

namespace revisit_slam {
namespace {

struct Options {
  std::string name, folder, out, topic = "/points";
  std::size_t max_scans = 0;
  bool uncorrected_elevation = false, quiet = false;
};

/// Returns how many scans could not be read.
std::size_t writeBag(const Options& options, const DatasetScans& scans, const std::string& path) {
  const std::size_t total =
      options.max_scans > 0 ? std::min(options.max_scans, scans.size()) : scans.size();
  Progress progress("converting", "scans", total, options.quiet);
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.setCompression(rosbag::compression::LZ4);
  std::size_t skipped = 0;
  for (std::size_t i = 0; i < total; ++i) {
    try {
      sensor_msgs::PointCloud2 cloud = toPointCloud2(scans.read(i));
      cloud.header.seq = static_cast<std::uint32_t>(i);
      bag.write(options.topic, std::max(cloud.header.stamp, ros::TIME_MIN), cloud);
    } catch (const DatasetError& error) {
      ++skipped;
      progress.say(std::string("scan skipped: ") + error.what());
    }
    progress.update(i + 1);
  }
  bag.close();
  progress.finish();
  if (skipped == total) throw std::runtime_error("not one scan could be read");
  return skipped;
}

void writeTruth(const Options& options, const DatasetScans& scans) {
  const std::optional<Trajectory> truth = scans.groundTruth();
  if (!truth) return;
  std::filesystem::path path(options.out);
  if (path.extension() == ".bag") path.replace_extension();
  std::ostringstream lines;
  for (const StampedPose& pose : *truth) writeTumLine(lines, pose);
  writeWholeText(path.string() + ".gt.tum", lines.str());
}

void convert(const Options& options) {
  DatasetOptions dataset_options;
  dataset_options.correct_kitti_elevation = !options.uncorrected_elevation;
  const auto scans = openDataset(options.name, options.folder, dataset_options);
  std::size_t skipped = 0;
  writeWholeFile(options.out, [&](const std::string& temporary) {
    skipped = writeBag(options, *scans, temporary);
  });
  if (skipped > 0) std::cerr << skipped << " damaged scans were skipped\n";
  writeTruth(options, *scans);
}

Options parseOptions(CLI::App& app, int argc, char** argv) {
  Options options;
  app.add_option("name", options.name, "which dataset")
      ->required()
      ->check(CLI::IsMember(datasetNames()));
  app.add_option("folder", options.folder, "one sequence as it was distributed")->required();
  app.add_option("--out", options.out, "bag to write; FILE.gt.tum is put beside it")->required();
  app.add_option("--points,--topic", options.topic, "topic of the scans")->capture_default_str();
  app.add_option("--max-scans", options.max_scans, "stop after so many scans; 0: all");
  app.add_flag("--uncorrected-elevation", options.uncorrected_elevation,
               "leave the points of KITTI as they are, 0.205 degrees too low");
  app.add_flag("--quiet", options.quiet, "no progress, only errors");
  app.parse(argc, argv);
  return options;
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  CLI::App app{"Writes a sequence of a public dataset as a bag"};
  try {
    revisit_slam::convert(revisit_slam::parseOptions(app, argc, argv));
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << "convert_dataset: " << error.what() << "\n";
    return 1;
  }
}
