// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/loops/recognition/place_recognition.h"

namespace revisit_slam {

/// Two local maps of different sessions that seem to show the same place.
struct Candidate {
  std::string source, target;  ///< names of the sessions
  PlaceMatch match;            ///< with the ids that the local maps have in their folders
};

/// A line for each, to the last bit.
std::string candidateText(const std::vector<Candidate>& candidates);
/// @throws std::runtime_error naming a file that cannot be read, and the line that is wrong.
std::vector<Candidate> readCandidates(const std::string& path);

}  // namespace revisit_slam
