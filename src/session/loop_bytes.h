// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

#include "revisit_slam/io/bytes.h"
#include "revisit_slam/session/graph_log.h"

namespace revisit_slam {

/// Loops as bytes of the files of a session (docs/session_format.md).

inline void put(const LoopConstraint& loop, ByteWriter& bytes) {
  bytes.put(loop.constraint.from);
  bytes.put(loop.constraint.to);
  bytes.put(loop.constraint.T_from_to);
  bytes.put(loop.constraint.information);
  bytes.put(loop.target);
  bytes.put(loop.source);
  bytes.put(loop.target_map);
  bytes.put(loop.source_map);
  bytes.put(static_cast<std::uint8_t>(loop.origin));
  bytes.put(loop.fitness);
  bytes.put(static_cast<std::int32_t>(loop.inliers));
}

template <typename Choice>
Choice choice(ByteReader& bytes, Choice last) {
  const auto number = bytes.get<std::uint8_t>();
  if (number > static_cast<std::uint8_t>(last))
    throw std::runtime_error("a record has a choice that there is not");
  return static_cast<Choice>(number);
}

inline LoopConstraint getLoop(ByteReader& bytes) {
  LoopConstraint loop;
  loop.constraint.from = bytes.id<ScanId>();
  loop.constraint.to = bytes.id<ScanId>();
  loop.constraint.T_from_to = bytes.pose();
  loop.constraint.information = bytes.matrix();
  loop.target = bytes.id<SubmapId>();
  loop.source = bytes.id<SubmapId>();
  loop.target_map = bytes.id<LocalMapId>();
  loop.source_map = bytes.id<LocalMapId>();
  loop.origin = choice(bytes, LoopOrigin::retroactive);
  loop.fitness = bytes.get<double>();
  loop.inliers = bytes.get<std::int32_t>();
  return loop;
}

inline void put(const GraphOptimised::Decision& decision, ByteWriter& bytes) {
  bytes.put(static_cast<std::uint8_t>(decision.state));
  bytes.put(decision.chi2_before);
  bytes.put(decision.chi2_after);
  bytes.put(decision.weight);
}

inline GraphOptimised::Decision getDecision(ByteReader& bytes) {
  GraphOptimised::Decision decision{};
  decision.state = choice(bytes, LoopState::disabled);
  decision.chi2_before = bytes.get<double>();
  decision.chi2_after = bytes.get<double>();
  decision.weight = bytes.get<double>();
  return decision;
}

}  // namespace revisit_slam
