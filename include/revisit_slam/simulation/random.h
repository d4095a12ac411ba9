// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace revisit_slam::simulation {

/// Scrambles 64 bits so that neighbouring inputs give unrelated outputs.
std::uint64_t mixBits(std::uint64_t bits);

/// A number that belongs to a place in a sequence: the same counters give the same number on any
/// thread, in any order.
std::uint64_t hashOf(std::uint64_t seed, std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0);

/// Uniform in [0, 1) from the bits of a hash.
double unitFrom(std::uint64_t hash);

/// Normal with mean 0 and variance 1 from the bits of a hash.
double gaussianFrom(std::uint64_t hash);

/// A sequence of random numbers for what is built once and in order, such as a house.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mixBits(seed)) {}

  double uniform(double low, double high);
  /// Both ends are possible.
  int integer(int low, int high);
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  /// -1 or +1.
  double sign() { return chance(0.5) ? 1.0 : -1.0; }

 private:
  std::uint64_t state_;
};

/// Smooth noise over the plane: values in [-1, 1], twice continuously differentiable, features of
/// the size of one unit.
double smoothNoise(std::uint64_t seed, double x, double y);

/// Sum of `octaves` smooth noises, each half the size and half the height of the one before.
double layeredNoise(std::uint64_t seed, double x, double y, int octaves);

}  // namespace revisit_slam::simulation
