// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/map_consistency.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace revisit_slam {

MapConsistency summarise(std::vector<CellConsistency> cells, std::vector<CellMaps> worst) {
  MapConsistency result;
  NearestDistances all;
  for (const CellConsistency& cell : cells) all += cell.distances;
  result.share = all.share();
  result.worst = std::move(worst);

  const auto unpaired = [](const CellConsistency& cell) { return cell.distances.paired == 0; };
  const auto end = std::remove_if(cells.begin(), cells.end(), unpaired);
  result.cells_without_pairs = static_cast<std::size_t>(cells.end() - end);
  cells.erase(end, cells.end());

  double sum = 0.0, squared_sum = 0.0;
  const auto count = static_cast<double>(cells.size());  // 0 / 0 is NaN
  for (const CellConsistency& cell : cells) sum += cell.distances.rms();
  result.mean = sum / count;
  for (const CellConsistency& cell : cells)
    squared_sum += std::pow(cell.distances.rms() - result.mean, 2);
  result.standard_deviation = std::sqrt(squared_sum / count);
  result.cells = std::move(cells);
  return result;
}

}  // namespace revisit_slam
