// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/route_file.h"

#include <fstream>
#include <sstream>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kKittiPeriod = 0.1;
constexpr std::size_t kTumColumns = 8;
constexpr std::size_t kKittiColumns = 12;

std::vector<double> numbersIn(const std::string& line) {
  std::istringstream stream(line);
  std::vector<double> numbers;
  for (double number; stream >> number;) numbers.push_back(number);
  return stream.eof() ? numbers : std::vector<double>{};
}

void addRow(RecordedRoute& route, const std::vector<double>& row) {
  if (row.size() == kTumColumns) {
    route.times.push_back(row[0]);
    route.positions.emplace_back(row[1], row[2], row[3]);
    return;
  }
  route.times.push_back(kKittiPeriod * static_cast<double>(route.times.size()));
  route.positions.emplace_back(row[11], -row[3], -row[7]);
}

void beginAtOrigin(RecordedRoute& route) {
  const double start = route.times.front();
  const Eigen::Vector3d origin = route.positions.front();
  for (double& time : route.times) time -= start;
  for (auto& position : route.positions) position -= origin;
}

}  // namespace

RecordedRoute readRoute(const std::string& path) {
  std::ifstream file(path);
  if (!file)
    throw ParameterError("route = '" + path + "': neither a route's name nor a readable file");
  RecordedRoute route;
  std::size_t number = 0, columns = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    const std::vector<double> row = numbersIn(line);
    if (columns == 0) columns = row.size();
    const bool known = row.size() == kTumColumns || row.size() == kKittiColumns;
    const bool later =
        route.times.empty() || row.size() != kTumColumns || row[0] > route.times.back();
    if (!known || row.size() != columns || !later) {
      throw ParameterError("route = '" + path + "', line " + std::to_string(number) +
                           ": must be a TUM row of 8 numbers with increasing stamps or a KITTI row "
                           "of 12 numbers");
    }
    addRow(route, row);
  }
  if (route.times.size() < 2)
    throw ParameterError("route = '" + path + "': has fewer than two poses");
  beginAtOrigin(route);
  return route;
}

}  // namespace revisit_slam::simulation
