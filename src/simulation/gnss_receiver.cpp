// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/gnss_receiver.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

enum Kind : std::uint64_t { kNoise = 9100, kOutage, kJump, kDirection };

/// Pieces of the drive, s since its start.
struct Piece {
  double begin, end;
};

/// One in each of as many equal parts of the drive, where chance has it.
std::vector<Piece> piecesOf(double seconds, int count, double length, std::uint64_t seed,
                            std::uint64_t kind) {
  std::vector<Piece> pieces;
  for (int i = 0; i < count; ++i) {
    const double part = seconds / count;
    const double room = std::max(0.0, part - length);
    const double begin =
        i * part + room * unitFrom(hashOf(seed, kind, static_cast<std::uint64_t>(i)));
    pieces.push_back({begin, begin + std::min(length, part)});
  }
  return pieces;
}

/// The number of the piece that holds this time, or -1.
int pieceAt(const std::vector<Piece>& pieces, double seconds) {
  const auto piece = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& p) {
    return p.begin <= seconds && seconds < p.end;
  });
  return piece == pieces.end() ? -1 : static_cast<int>(piece - pieces.begin());
}

}  // namespace

std::vector<GnssSample> simulateGnss(const Route& route, Stamp end,
                                     const GnssReceiverConfig& config) {
  const LocalEnu enu(config.datum);
  const double seconds = secondsBetween(route.start(), end);
  const int outages = static_cast<int>(std::lround(config.outages * seconds / config.outage_time));
  const std::vector<Piece> without =
      piecesOf(seconds, std::max(outages, config.outages > 0.0 ? 1 : 0), config.outage_time,
               config.seed, kOutage);
  const std::vector<Piece> displaced =
      piecesOf(seconds, config.jumps, config.jump_time, config.seed, kJump);
  std::vector<GnssSample> samples;
  for (std::uint64_t i = 0; static_cast<double>(i) < seconds * config.rate; ++i) {
    const double time = static_cast<double>(i) / config.rate;
    GnssSample sample;
    sample.stamp = route.start().plusSeconds(time);
    sample.has_position = pieceAt(without, time) < 0;
    sample.deviation = config.noise;
    Eigen::Vector3d p_enu = route.poseAt(sample.stamp) * config.p_base_antenna;
    for (int axis = 0; axis < 3; ++axis)
      p_enu[axis] += (axis == 2 ? 2.0 : 1.0) * config.noise *
                     gaussianFrom(hashOf(config.seed, kNoise, i, static_cast<std::uint64_t>(axis)));
    const int jump = pieceAt(displaced, time);
    const double direction =
        2.0 * M_PI *
        unitFrom(hashOf(config.seed, kDirection, static_cast<std::uint64_t>(std::max(jump, 0))));
    if (jump >= 0)
      p_enu += config.jump * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0);
    sample.position = enu.toGeodetic(p_enu);
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace revisit_slam::simulation
