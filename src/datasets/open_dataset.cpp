// SPDX-License-Identifier: MIT
#include "revisit_slam/datasets/open_dataset.h"

#include <functional>
#include <utility>

#include "revisit_slam/datasets/readers.h"

namespace revisit_slam {
namespace {

using Open = std::function<DatasetScansPtr(const std::string&, const DatasetOptions&)>;

Open helipr(const std::string& sensor) {
  return [sensor](const std::string& folder, const DatasetOptions&) {
    return openHelipr(folder, sensor);
  };
}

Open plain(DatasetScansPtr (*open)(const std::string&)) {
  return [open](const std::string& folder, const DatasetOptions&) { return open(folder); };
}

const std::vector<std::pair<std::string, Open>>& readers() {
  static const std::vector<std::pair<std::string, Open>> all{
      {"helipr-ouster", helipr("Ouster")},
      {"helipr-avia", helipr("Avia")},
      {"helipr-aeva", helipr("Aeva")},
      {"helipr-velodyne", helipr("Velodyne")},
      {"mulran", plain(openMulran)},
      {"apollo", plain(openApollo)},
      {"newer-college", plain(openNewerCollege)},
      {"kitti-odometry", openKittiOdometry},
      {"kitti-raw", openKittiRaw},
  };
  return all;
}

std::string namesInWords() {
  std::string text;
  for (const std::string& name : datasetNames()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

const std::vector<std::string>& datasetNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& reader : readers()) all.push_back(reader.first);
    return all;
  }();
  return names;
}

std::unique_ptr<DatasetScans> openDataset(const std::string& name, const std::string& folder,
                                          const DatasetOptions& options) {
  for (const auto& [known, open] : readers())
    if (known == name) return open(folder, options);
  throw DatasetError(name, "no such dataset; there are: " + namesInWords());
}

}  // namespace revisit_slam
