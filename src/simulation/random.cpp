// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/random.h"

#include <cmath>

namespace revisit_slam::simulation {
namespace {

constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ULL;
constexpr double kTwoPi = 6.283185307179586;

double latticeValue(std::uint64_t seed, double x, double y) {
  const auto i = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
  const auto j = static_cast<std::uint64_t>(static_cast<std::int64_t>(y));
  return 2.0 * unitFrom(hashOf(seed, i, j)) - 1.0;
}

double fade(double t) {
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

}  // namespace

std::uint64_t mixBits(std::uint64_t bits) {
  bits += kGolden;
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ULL;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBULL;
  return bits ^ (bits >> 31);
}

std::uint64_t hashOf(std::uint64_t seed, std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  return mixBits(mixBits(mixBits(mixBits(seed) ^ a) ^ b) ^ c);
}

double unitFrom(std::uint64_t hash) {
  return static_cast<double>(hash >> 11) * 0x1.0p-53;
}

double gaussianFrom(std::uint64_t hash) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - unitFrom(hash)));
  return radius * std::cos(kTwoPi * unitFrom(mixBits(hash)));
}

double Random::uniform(double low, double high) {
  state_ += kGolden;
  return low + (high - low) * unitFrom(mixBits(state_));
}

int Random::integer(int low, int high) {
  return low + static_cast<int>(uniform(0.0, static_cast<double>(high - low + 1)));
}

double smoothNoise(std::uint64_t seed, double x, double y) {
  const double x0 = std::floor(x), y0 = std::floor(y);
  const double u = fade(x - x0), v = fade(y - y0);
  const double low = (1.0 - u) * latticeValue(seed, x0, y0) + u * latticeValue(seed, x0 + 1, y0);
  const double high =
      (1.0 - u) * latticeValue(seed, x0, y0 + 1) + u * latticeValue(seed, x0 + 1, y0 + 1);
  return (1.0 - v) * low + v * high;
}

double layeredNoise(std::uint64_t seed, double x, double y, int octaves) {
  double sum = 0.0, scale = 1.0;
  for (int i = 0; i < octaves; ++i, scale *= 2.0) {
    sum += smoothNoise(seed + static_cast<std::uint64_t>(i), x * scale, y * scale) / scale;
  }
  return sum;
}

}  // namespace revisit_slam::simulation
