// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/datasets/dataset_error.h"
#include "revisit_slam/input/point_cloud.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// A scan on disk. docs/datasets.md says for each dataset which instant of the sweep its stamp is.
struct ScanFile {
  std::string path;
  Stamp stamp;
};

/// The scans of a dataset folder in the order of their stamps, each read when it is asked for.
class DatasetScans {
 public:
  virtual ~DatasetScans() = default;

  std::size_t size() const { return scans_.size(); }
  const ScanFile& file(std::size_t index) const { return scans_[index]; }
  /// The frame_id of all scans.
  const std::string& frame() const { return frame_; }

  /// Fields x, y, z, and those of the format; point times where the scan is as measured.
  /// @throws DatasetError naming the file where that is missing or damaged; other scans can still
  /// be read.
  PointCloud read(std::size_t index) const;

  /// Poses of the sensor in the dataset's own world, with the dataset's own stamps; nothing where
  /// the folder has none. @throws DatasetError naming the file, and the line where one is damaged.
  virtual std::optional<Trajectory> groundTruth() const = 0;

 protected:
  DatasetScans(std::string frame, std::vector<ScanFile> scans)
      : frame_(std::move(frame)), scans_(std::move(scans)) {}

 private:
  /// All of the scan but its stamp and frame.
  virtual PointCloud readPoints(std::size_t index) const = 0;

  std::string frame_;
  std::vector<ScanFile> scans_;
};

}  // namespace revisit_slam
