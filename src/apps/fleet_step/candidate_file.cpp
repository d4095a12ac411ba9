// SPDX-License-Identifier: MIT
#include "candidate_file.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace revisit_slam {
namespace {

constexpr char kHeader[] =
    "source,source_map,target,target_map,inliers,matches,rms,qx,qy,qz,qw,x,y,z";

/// @throws std::invalid_argument for what is no number.
Candidate candidateOf(const std::string& line) {
  std::istringstream fields(line);
  std::string field;
  const auto next = [&] {
    std::getline(fields, field, ',');
    return field;
  };
  Candidate candidate;
  candidate.source = next();
  candidate.match.source.value = static_cast<std::uint32_t>(std::stoul(next()));
  candidate.target = next();
  candidate.match.target.value = static_cast<std::uint32_t>(std::stoul(next()));
  candidate.match.inliers = std::stoi(next());
  candidate.match.matches = std::stoi(next());
  candidate.match.rms = std::stod(next());
  std::array<double, 7> values{};
  for (double& value : values) value = std::stod(next());
  const auto& [qx, qy, qz, qw, x, y, z] = values;
  candidate.match.T_target_source = {Eigen::Quaterniond(qw, qx, qy, qz), {x, y, z}};
  return candidate;
}

}  // namespace

std::string candidateText(const std::vector<Candidate>& candidates) {
  std::string text = std::string(kHeader) + "\n";
  for (const Candidate& candidate : candidates) {
    const PlaceMatch& match = candidate.match;
    const Eigen::Quaterniond& q = match.T_target_source.rotation;
    const Eigen::Vector3d& t = match.T_target_source.translation;
    std::array<char, 256> numbers{};
    std::snprintf(numbers.data(), numbers.size(),
                  "%d,%d,%.6g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", match.inliers,
                  match.matches, match.rms, q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z());
    text += candidate.source + "," + std::to_string(match.source.value) + "," + candidate.target +
            "," + std::to_string(match.target.value) + "," + numbers.data();
  }
  return text;
}

std::vector<Candidate> readCandidates(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != kHeader)
    throw std::runtime_error("'" + path + "' is no file of candidates");
  std::vector<Candidate> candidates;
  while (std::getline(file, line)) {
    try {
      candidates.push_back(candidateOf(line));
    } catch (const std::logic_error&) {
      throw std::runtime_error("'" + path + "': line " + std::to_string(candidates.size() + 2) +
                               " is no candidate");
    }
  }
  return candidates;
}

}  // namespace revisit_slam
