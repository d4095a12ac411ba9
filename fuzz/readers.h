// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace revisit_slam::fuzz {

using Seeds = std::vector<std::string>;

// A reader and its seeds are in the file of that name.

void readPointCloud2(const std::string& bytes);
Seeds seedsOfPointCloud2();
void readLivox(const std::string& bytes);
Seeds seedsOfLivox();
void readPointTimes(const std::string& bytes);
Seeds seedsOfPointTimes();
void readPoseGraph(const std::string& bytes);
Seeds seedsOfPoseGraph();
void readPointFile(const std::string& bytes);
Seeds seedsOfPointFile();
void readDatasets(const std::string& bytes);
Seeds seedsOfDatasets();
void readTrajectories(const std::string& bytes);
Seeds seedsOfTrajectories();
void readParameters(const std::string& bytes);
Seeds seedsOfParameters();
void readSessionFiles(const std::string& bytes);
Seeds seedsOfSession();

}  // namespace revisit_slam::fuzz
