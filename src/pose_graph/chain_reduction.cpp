// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/chain_reduction.h"

#include <limits>

#include "revisit_slam/pose_graph/gauge.h"
#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr std::uint32_t kInner = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kPiecesAtOnce = 8;

/// How many odometry constraints come into and go out of a node, forward in time.
struct Degree {
  int in = 0, out = 0;
};

/// A node is inner to a chain when all it has is one constraint from before and one to after.
std::vector<bool> innerNodes(const PoseGraph& graph) {
  std::vector<Degree> degrees(graph.poses().size());
  std::vector<bool> inner(graph.poses().size(), true);
  const auto keepEndsOf = [&](const Constraint& constraint) {
    inner[constraint.from.value] = inner[constraint.to.value] = false;
  };
  for (const Constraint& constraint : graph.odometry()) {
    ++degrees[constraint.from.value].out;
    ++degrees[constraint.to.value].in;
    if (constraint.to < constraint.from) keepEndsOf(constraint);
  }
  for (const Constraint& loop : graph.loops()) keepEndsOf(loop);
  for (const ScanId gauge : gaugeNodes(graph)) inner[gauge.value] = false;
  for (std::size_t i = 0; i < degrees.size(); ++i)
    if (degrees[i].in != 1 || degrees[i].out != 1) inner[i] = false;
  return inner;
}

}  // namespace

ChainReduction::ChainReduction(const PoseGraph& graph) {
  keepNodes(graph);
  cutPieces(graph);
  compose(graph);
}

void ChainReduction::keepNodes(const PoseGraph& graph) {
  const std::vector<bool> inner = innerNodes(graph);
  reduced_of_.assign(inner.size(), kInner);
  for (std::uint32_t i = 0; i < inner.size(); ++i) {
    if (inner[i]) continue;
    reduced_of_[i] = reduced_.addNode(graph.poses()[i]).value;
    kept_.push_back(ScanId{i});
  }
}

void ChainReduction::cutPieces(const PoseGraph& graph) {
  std::vector<const Constraint*> onwards(graph.poses().size(), nullptr);  // of inner nodes
  for (const Constraint& constraint : graph.odometry())
    if (reduced_of_[constraint.from.value] == kInner) onwards[constraint.from.value] = &constraint;
  for (const Constraint& constraint : graph.odometry()) {
    if (reduced_of_[constraint.from.value] == kInner) continue;
    ChainPiece piece{&constraint};
    while (reduced_of_[piece.back()->to.value] == kInner)
      piece.push_back(onwards[piece.back()->to.value]);
    pieces_.push_back({ScanId{reduced_of_[constraint.from.value]},
                       ScanId{reduced_of_[piece.back()->to.value]}, std::move(piece)});
  }
}

void ChainReduction::compose(const PoseGraph& graph) {
  std::vector<Constraint> constraints(pieces_.size());
  Chunks(pieces_.size(), kPiecesAtOnce).forEach([&](std::size_t, Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      constraints[i] = composed(pieces_[i].constraints);
      constraints[i].from = pieces_[i].first;
      constraints[i].to = pieces_[i].last;
    }
  });
  for (const Constraint& constraint : constraints) reduced_.addOdometry(constraint);
  for (Constraint loop : graph.loops()) {
    loop.from = ScanId{reduced_of_[loop.from.value]};
    loop.to = ScanId{reduced_of_[loop.to.value]};
    reduced_.addLoop(loop);
  }
}

std::vector<Pose> ChainReduction::expand(const std::vector<Pose>& reduced_poses) const {
  std::vector<Pose> poses(reduced_of_.size());
  for (std::size_t i = 0; i < kept_.size(); ++i) poses[kept_[i].value] = reduced_poses[i];
  Chunks(pieces_.size(), kPiecesAtOnce).forEach([&](std::size_t, Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Piece& piece = pieces_[i];
      const std::vector<Pose> inner = bentPiece(piece.constraints, reduced_poses[piece.first.value],
                                                reduced_poses[piece.last.value]);
      for (std::size_t k = 0; k < inner.size(); ++k)
        poses[piece.constraints[k]->to.value] = inner[k];
    }
  });
  return poses;
}

}  // namespace revisit_slam
