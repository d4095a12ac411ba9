// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "revisit_slam/simulation/terrain.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kCell = 4.0;
constexpr double kMargin = 160.0;

/// Mean height and how well it is known: 0 not at all, 1 fully.
struct Layer {
  Eigen::ArrayXXd height;
  Eigen::ArrayXXd weight;
};

Layer halve(const Layer& fine) {
  const long columns = (fine.height.rows() + 1) / 2, rows = (fine.height.cols() + 1) / 2;
  Layer coarse{Eigen::ArrayXXd::Zero(columns, rows), Eigen::ArrayXXd::Zero(columns, rows)};
  for (long j = 0; j < fine.height.cols(); ++j) {
    for (long i = 0; i < fine.height.rows(); ++i) {
      coarse.height(i / 2, j / 2) += fine.weight(i, j) * fine.height(i, j);
      coarse.weight(i / 2, j / 2) += fine.weight(i, j);
    }
  }
  coarse.height /= coarse.weight.max(1e-12);
  coarse.weight = coarse.weight.min(1.0);
  return coarse;
}

double between(const Eigen::ArrayXXd& coarse, long i, long j) {
  const double x =
      std::clamp(0.5 * static_cast<double>(i) - 0.25, 0.0, static_cast<double>(coarse.rows() - 1));
  const double y =
      std::clamp(0.5 * static_cast<double>(j) - 0.25, 0.0, static_cast<double>(coarse.cols() - 1));
  const long x0 = static_cast<long>(x), y0 = static_cast<long>(y);
  const long x1 = std::min(x0 + 1, coarse.rows() - 1), y1 = std::min(y0 + 1, coarse.cols() - 1);
  const double u = x - static_cast<double>(x0), v = y - static_cast<double>(y0);
  return (1 - v) * ((1 - u) * coarse(x0, y0) + u * coarse(x1, y0)) +
         v * ((1 - u) * coarse(x0, y1) + u * coarse(x1, y1));
}

/// Fills unknown cells from a coarser picture of the known ones.
Eigen::ArrayXXd fill(const Layer& fine) {
  if (fine.height.size() == 1) return fine.height;
  const Eigen::ArrayXXd coarse = fill(halve(fine));
  Eigen::ArrayXXd filled = fine.height;
  for (long j = 0; j < filled.cols(); ++j) {
    for (long i = 0; i < filled.rows(); ++i) {
      const double w = fine.weight(i, j);
      filled(i, j) = w * fine.height(i, j) + (1.0 - w) * between(coarse, i, j);
    }
  }
  return filled;
}

Eigen::ArrayXXd smoothed(const Eigen::ArrayXXd& grid) {
  Eigen::ArrayXXd result = grid;
  for (long j = 1; j + 1 < grid.cols(); ++j) {
    for (long i = 1; i + 1 < grid.rows(); ++i) {
      result(i, j) = grid.block<3, 3>(i - 1, j - 1).mean();
    }
  }
  return result;
}

}  // namespace

HeightGrid::HeightGrid(const std::vector<Eigen::Vector3d>& anchors) {
  Eigen::Vector2d low = anchors.front().head<2>(), high = low;
  for (const auto& p : anchors) {
    low = low.cwiseMin(p.head<2>());
    high = high.cwiseMax(p.head<2>());
  }
  origin_ = low.array() - kMargin;
  const Eigen::Vector2d size = (high - low).array() + 2.0 * kMargin;
  const long columns = static_cast<long>(size.x() / kCell) + 1;
  const long rows = static_cast<long>(size.y() / kCell) + 1;
  Layer layer{Eigen::ArrayXXd::Zero(columns, rows), Eigen::ArrayXXd::Zero(columns, rows)};
  for (const auto& p : anchors) {
    const long i = std::lround((p.x() - origin_.x()) / kCell);
    const long j = std::lround((p.y() - origin_.y()) / kCell);
    layer.height(i, j) += p.z();
    layer.weight(i, j) += 1.0;
  }
  layer.height /= layer.weight.max(1e-12);
  layer.weight = layer.weight.min(1.0);
  heights_ = fill(layer);
  for (int pass = 0; pass < 6; ++pass) heights_ = smoothed(heights_);
}

double HeightGrid::cell(long column, long row) const {
  return heights_(std::clamp(column, 0L, heights_.rows() - 1),
                  std::clamp(row, 0L, heights_.cols() - 1));
}

double HeightGrid::height(double x, double y) const {
  const double px = (x - origin_.x()) / kCell, py = (y - origin_.y()) / kCell;
  const double fx = std::floor(px), fy = std::floor(py);
  const auto weights = [](double u) -> Eigen::Vector4d {
    const double v = 1.0 - u;
    return Eigen::Vector4d(v * v * v, 3 * u * u * u - 6 * u * u + 4, 3 * v * v * v - 6 * v * v + 4,
                           u * u * u) /
           6.0;
  };
  const Eigen::Vector4d wx = weights(px - fx), wy = weights(py - fy);
  double sum = 0.0;
  for (long j = 0; j < 4; ++j) {
    for (long i = 0; i < 4; ++i) {
      sum += wx(i) * wy(j) * cell(static_cast<long>(fx) + i - 1, static_cast<long>(fy) + j - 1);
    }
  }
  return sum;
}

}  // namespace revisit_slam::simulation
