// SPDX-License-Identifier: MIT
#include "kitti_calibration.h"

#include <fstream>
#include <sstream>

#include "revisit_slam/datasets/dataset_error.h"
#include "text_rows.h"

namespace revisit_slam {
namespace {

/// The line "KEY: words" with its words.
TextRow entryOf(const std::string& path, const std::string& key, std::size_t count) {
  std::ifstream file(path);
  if (!file) throw DatasetError(path, "cannot be read");
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word != key + ":") continue;
    TextRow row{path, number, {}};
    while (words >> word) row.words.push_back(word);
    if (row.words.size() != count) row.fail(key + " has not " + std::to_string(count) + " values");
    return row;
  }
  throw DatasetError(path, "has no " + key);
}

}  // namespace

Pose readCameraCalibration(const std::string& path) {
  return entryOf(path, "Tr", 12).matrix(0);
}

Pose readImuCalibration(const std::string& path) {
  const TextRow rotation = entryOf(path, "R", 9), translation = entryOf(path, "T", 3);
  TextRow rows{path, rotation.line, {}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rows.words.push_back(rotation.words[3 * i + j]);
    rows.words.push_back(translation.words[i]);
  }
  return rows.matrix(0);
}

}  // namespace revisit_slam
