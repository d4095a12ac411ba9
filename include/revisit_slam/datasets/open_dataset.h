// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "revisit_slam/datasets/dataset_options.h"
#include "revisit_slam/datasets/dataset_scans.h"

namespace revisit_slam {

/// The names that openDataset takes.
const std::vector<std::string>& datasetNames();

/// The scans in `folder`, which holds one sequence as it was distributed (docs/datasets.md).
/// @throws DatasetError for an unknown name, and for a folder or list of stamps that cannot be
/// used.
std::unique_ptr<DatasetScans> openDataset(const std::string& name, const std::string& folder,
                                          const DatasetOptions& options = {});

}  // namespace revisit_slam
