// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/density_image.h"

#include <algorithm>

#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {
namespace {

/// The pixels of the points in range.
std::vector<Pixel> pixelsOf(const Points& points_local, const Pose& T_level_local,
                            const DensityImageConfig& config) {
  std::vector<Pixel> pixels;
  pixels.reserve(points_local.size());
  for (const Eigen::Vector3f& point : points_local) {
    const Eigen::Vector3d p = T_level_local * point.cast<double>();
    if (!(p.head<2>().norm() < config.radius)) continue;  // not a number: neither
    pixels.emplace_back(floorToInt(p.x() / config.resolution),
                        floorToInt(p.y() / config.resolution));
  }
  return pixels;
}

void fitTo(const std::vector<Pixel>& pixels, DensityImage& image) {
  Pixel least = pixels.front(), greatest = pixels.front();
  for (const Pixel& pixel : pixels) {
    least = least.cwiseMin(pixel);
    greatest = greatest.cwiseMax(pixel);
  }
  image.origin = least;
  image.width = greatest.x() - least.x() + 1;
  image.height = greatest.y() - least.y() + 1;
}

std::vector<int> countsOf(const std::vector<Pixel>& pixels, const DensityImage& image) {
  std::vector<int> counts(static_cast<std::size_t>(image.width) *
                          static_cast<std::size_t>(image.height));
  for (const Pixel& pixel : pixels) {
    const Pixel p = pixel - image.origin;
    ++counts[static_cast<std::size_t>(p.y()) * static_cast<std::size_t>(image.width) +
             static_cast<std::size_t>(p.x())];
  }
  return counts;
}

/// The smallest count is 1, that of a pixel with a point.
std::uint8_t greyLevel(int count, int largest, double min_density) {
  if (count <= 1 || largest <= 1) return 0;
  const double density = static_cast<double>(count - 1) / static_cast<double>(largest - 1);
  return density > min_density ? static_cast<std::uint8_t>(255.0 * density) : std::uint8_t{0};
}

}  // namespace

DensityImage densityImage(const Points& points_local, const Pose& T_level_local,
                          const DensityImageConfig& config) {
  DensityImage image;
  image.resolution = config.resolution;
  const std::vector<Pixel> pixels = pixelsOf(points_local, T_level_local, config);
  if (pixels.empty()) return image;
  fitTo(pixels, image);
  const std::vector<int> counts = countsOf(pixels, image);
  const int largest = *std::max_element(counts.begin(), counts.end());
  image.values.reserve(counts.size());
  for (const int count : counts)
    image.values.push_back(greyLevel(count, largest, config.min_density));
  return image;
}

}  // namespace revisit_slam
