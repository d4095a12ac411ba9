// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "revisit_slam/datasets/dataset_options.h"
#include "revisit_slam/datasets/dataset_scans.h"

namespace revisit_slam {

using DatasetScansPtr = std::unique_ptr<DatasetScans>;

// Each opens a folder with one sequence. @throws DatasetError

/// @param sensor Ouster, Avia, Aeva or Velodyne: the name of its folder.
DatasetScansPtr openHelipr(const std::string& folder, const std::string& sensor);
DatasetScansPtr openMulran(const std::string& folder);
DatasetScansPtr openApollo(const std::string& folder);
DatasetScansPtr openNewerCollege(const std::string& folder);
DatasetScansPtr openKittiOdometry(const std::string& folder, const DatasetOptions& options);
DatasetScansPtr openKittiRaw(const std::string& folder, const DatasetOptions& options);

}  // namespace revisit_slam
