// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/search/tried_pairs.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace revisit_slam {
namespace {

/// What registration makes up for from any guess.
constexpr double kUnmoved = 0.1;    // m
constexpr double kUnturned = 2e-3;  // rad: 0.05 m at the other end of a submap of 25 m
/// Of the drift.
constexpr double kUnchanged = 0.1;

bool areClose(const Pose& a, const Pose& b) {
  const Pose moved = a.inverse() * b;
  return moved.translation.norm() <= kUnmoved && moved.angle() <= kUnturned;
}

}  // namespace

bool PairGuess::isLike(const PairGuess& other) const {
  return areClose(T_target_source, other.T_target_source) &&
         areClose(T_target_source_last, other.T_target_source_last) &&
         (drift == other.drift ||
          std::abs(drift - other.drift) <= kUnchanged * std::min(drift, other.drift));
}

void TriedPairs::note(const LocalMapPair& pair, const PairGuess& guess) {
  guesses_.insert_or_assign(pair, guess);
}

void TriedPairs::forgetChanged(const GuessOf& guess_of) {
  for (auto tried = guesses_.begin(); tried != guesses_.end();)
    tried = tried->second.isLike(guess_of(tried->first)) ? std::next(tried) : guesses_.erase(tried);
}

}  // namespace revisit_slam
