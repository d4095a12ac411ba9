// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "candidate_file.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/slam/cross_registration.h"
#include "steps.h"

namespace revisit_slam {

void registerSessions(const RegisterOptions& options, const SlamConfig& config) {
  const NamedSession source{options.source.front(), options.source.back()},
      target{options.target.front(), options.target.back()};
  std::vector<PlaceMatch> matches;
  for (const Candidate& candidate : readCandidates(options.candidates))
    if (candidate.source == source.name && candidate.target == target.name)
      matches.push_back(candidate.match);
  if (matches.empty())
    throw std::runtime_error("'" + options.candidates + "' has none of '" + source.name +
                             "' and '" + target.name + "'");
  writeWholeText(options.out, encodeCrossing(registerMatches(source, target, matches, config)));
}

}  // namespace revisit_slam
