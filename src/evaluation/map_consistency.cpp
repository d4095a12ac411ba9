// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/map_consistency.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace revisit_slam {
namespace {

RmsStatistics statisticsOf(const std::vector<double>& values) {
  RmsStatistics result;
  result.count = values.size();
  const auto count = static_cast<double>(values.size());  // 0 / 0 is NaN
  double sum = 0.0, squared_sum = 0.0;
  for (const double value : values) sum += value;
  result.mean = sum / count;
  for (const double value : values) squared_sum += std::pow(value - result.mean, 2);
  result.standard_deviation = std::sqrt(squared_sum / count);
  return result;
}

}  // namespace

MapConsistency summarise(std::vector<CellConsistency> cells, std::vector<CellMaps> worst) {
  MapConsistency result;
  NearestDistances all;
  for (const CellConsistency& cell : cells) {
    all += cell.distances;
    result.thickness += cell.thickness;
  }
  result.share = all.share();
  result.worst = std::move(worst);

  const auto unpaired = [](const CellConsistency& cell) { return cell.distances.paired == 0; };
  const auto end = std::remove_if(cells.begin(), cells.end(), unpaired);
  result.cells_without_pairs = static_cast<std::size_t>(cells.end() - end);
  cells.erase(end, cells.end());

  std::vector<double> of_pairs, of_cells;
  for (const CellConsistency& cell : cells) {
    of_cells.push_back(cell.distances.rms());
    for (const NearestDistances& pair : cell.pairs)
      if (pair.paired > 0) of_pairs.push_back(pair.rms());
  }
  result.of_pairs = statisticsOf(of_pairs);
  result.of_cells = statisticsOf(of_cells);
  result.cells = std::move(cells);
  return result;
}

}  // namespace revisit_slam
