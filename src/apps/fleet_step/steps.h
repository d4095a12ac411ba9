// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "revisit_slam/loops/recognition/place_candidates.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

// What mapping many recordings consists of after each has been mapped by `offline`. Each step reads
// and writes whole files.

/// What the user asked for of all steps.
struct StepOptions {
  std::vector<std::string> settings;
  std::string preset, parameter_file;
  int threads = 0;
};
SlamConfig configOf(const StepOptions& options);

struct SummariseOptions {
  std::string session, name, out;
};
void summariseSession(const SummariseOptions& options);

struct CandidatesOptions {
  std::vector<std::string> summaries;
  std::string out;
  PlaceCandidatesConfig config;
  std::size_t of = 0;  // sessions that are searched for; 0: all
  bool exhaustive = false;
};
void findCandidates(const CandidatesOptions& options, const SlamConfig& config);

struct RegisterOptions {
  std::vector<std::string> source, target;  // name, folder
  std::string candidates, out;
};
void registerSessions(const RegisterOptions& options, const SlamConfig& config);

struct SolveOptions {
  std::vector<std::string> summaries, crossings;
  std::string out;
};
void solveJointly(const SolveOptions& options, const SlamConfig& config);

}  // namespace revisit_slam
