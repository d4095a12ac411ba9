// SPDX-License-Identifier: MIT
#include <exception>

#include "readers.h"
#include "target.h"

namespace revisit_slam::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all{
      {"pointcloud2", readPointCloud2, seedsOfPointCloud2},
      {"livox", readLivox, seedsOfLivox},
      {"point_times", readPointTimes, seedsOfPointTimes},
      {"g2o", readPoseGraph, seedsOfPoseGraph},
      {"pcd", readPointFile, seedsOfPointFile},
      {"datasets", readDatasets, seedsOfDatasets},
      {"trajectory", readTrajectories, seedsOfTrajectories},
      {"parameters", readParameters, seedsOfParameters},
      {"session", readSessionFiles, seedsOfSession},
  };
  return all;
}

void answer(const Target& target, const std::string& bytes) {
  try {
    target.read(bytes);
  } catch (const std::exception&) {
  }
}

}  // namespace revisit_slam::fuzz
