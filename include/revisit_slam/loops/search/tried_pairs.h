// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>

#include "revisit_slam/loops/search/retroactive_search.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// What a pair of local maps is registered from.
struct PairGuess {
  Pose T_target_source;       ///< of the first submaps of both maps
  Pose T_target_source_last;  ///< of the last ones: the maps may bend
  double drift = 0.0;         ///< m, standard deviation in the plane, which ambiguity depends on

  /// Whether another result is hardly to be expected.
  bool isLike(const PairGuess& other) const;
};

/// Pairs of local maps that were registered, and from which guess.
class TriedPairs {
 public:
  using GuessOf = std::function<PairGuess(const LocalMapPair&)>;

  bool has(const LocalMapPair& pair) const { return guesses_.count(pair) > 0; }
  void note(const LocalMapPair& pair, const PairGuess& guess);
  void clear() { guesses_.clear(); }
  /// Pairs of which the graph says something else by now.
  void forgetChanged(const GuessOf& guess_of);

 private:
  std::map<LocalMapPair, PairGuess> guesses_;
};

}  // namespace revisit_slam
