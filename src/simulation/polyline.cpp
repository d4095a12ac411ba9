// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/polyline.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam::simulation {

std::vector<double> arcLengths(const Polyline& line) {
  std::vector<double> arcs(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    arcs[i] = arcs[i - 1] + (line[i] - line[i - 1]).head<2>().norm();
  }
  return arcs;
}

Polyline resampled(const Polyline& line, double step) {
  const std::vector<double> arcs = arcLengths(line);
  const auto count = static_cast<std::size_t>(arcs.back() / step) + 1;
  Polyline result;
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double arc = static_cast<double>(k) * step;
    while (i + 2 < line.size() && arcs[i + 1] <= arc) ++i;
    if (line.size() < 2) return line;
    const double part = std::max(arcs[i + 1] - arcs[i], 1e-9);
    const double u = std::clamp((arc - arcs[i]) / part, 0.0, 1.0);
    result.push_back((1.0 - u) * line[i] + u * line[i + 1]);
  }
  return result;
}

Polyline smoothed(const Polyline& line, double sigma_in_points) {
  const long reach = std::lround(std::ceil(4.0 * sigma_in_points));
  const long last = static_cast<long>(line.size()) - 1;
  // Beyond an end the line goes on as its mirror image through that end.
  const auto at = [&](long i) -> Eigen::Vector3d {
    const auto inside = [&](long k) {
      return line[static_cast<std::size_t>(std::clamp(k, 0L, last))];
    };
    if (i < 0) return 2.0 * line.front() - inside(-i);
    if (i > last) return 2.0 * line.back() - inside(2 * last - i);
    return inside(i);
  };
  std::vector<double> kernel;
  double total = 0.0;
  for (long k = -reach; k <= reach; ++k) {
    const double x = static_cast<double>(k) / sigma_in_points;
    kernel.push_back(std::exp(-0.5 * x * x));
    total += kernel.back();
  }
  Polyline result(line.size());
  for (long i = 0; i <= last; ++i) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (long k = -reach; k <= reach; ++k)
      sum += kernel[static_cast<std::size_t>(k + reach)] * at(i + k);
    result[static_cast<std::size_t>(i)] = sum / total;
  }
  return result;
}

Eigen::Vector2d directionAt(const Polyline& line, std::size_t index) {
  const Eigen::Vector3d& next = line[std::min(index + 1, line.size() - 1)];
  const Eigen::Vector3d& previous = line[index == 0 ? 0 : index - 1];
  return (next - previous).head<2>().normalized();
}

Polyline movedRight(const Polyline& line, const std::function<double(double)>& offset) {
  const std::vector<double> arcs = arcLengths(line);
  Polyline result = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector2d along = directionAt(line, i);
    result[i].head<2>() += offset(arcs[i]) * Eigen::Vector2d(along.y(), -along.x());
  }
  return result;
}

Polyline shortened(const Polyline& line, double length) {
  const std::vector<double> arcs = arcLengths(line);
  const auto end = std::upper_bound(arcs.begin(), arcs.end(), length) - arcs.begin();
  return Polyline(line.begin(), line.begin() + end);
}

}  // namespace revisit_slam::simulation
