// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/chain_reduction.h"

#include <limits>

#include "revisit_slam/pose_graph/gauge.h"
#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr NodeId kInner{std::numeric_limits<std::uint32_t>::max()};
constexpr std::size_t kPiecesAtOnce = 8;

/// How many links come into and go out of a node.
struct Degree {
  int in = 0, out = 0;
};

/// A node is inner to a chain when all it has is one link from before and one to after.
std::vector<bool> innerNodes(const PoseGraph& graph) {
  std::vector<Degree> degrees(graph.poses().size());
  std::vector<bool> inner(graph.poses().size(), true);
  for (const Factor& factor : graph.factors()) {
    if (const RelativePoseFactor* link = chainLink(factor)) {
      ++degrees[link->from().value].out;
      ++degrees[link->to().value].in;
    } else {
      for (const NodeId node : factor.nodes()) inner[node.value] = false;
    }
  }
  for (const NodeId gauge : gaugeNodes(graph)) inner[gauge.value] = false;
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
    reduced_of_[i] = reduced_.addNode(graph.poses()[i]);
    kept_.push_back(NodeId{i});
  }
}

void ChainReduction::cutPieces(const PoseGraph& graph) {
  const auto reducedOf = [&](NodeId node) { return reduced_of_[node.value]; };
  std::vector<const RelativePoseFactor*> onwards(graph.poses().size(), nullptr);  // of inner nodes
  std::vector<const RelativePoseFactor*> first;
  for (const Factor& factor : graph.factors()) {
    const RelativePoseFactor* link = chainLink(factor);
    if (link == nullptr) continue;
    if (reducedOf(link->from()) == kInner)
      onwards[link->from().value] = link;
    else
      first.push_back(link);
  }
  for (const RelativePoseFactor* link : first) {
    ChainPiece piece{link};
    while (reducedOf(piece.back()->to()) == kInner)
      piece.push_back(onwards[piece.back()->to().value]);
    pieces_.push_back({reducedOf(link->from()), reducedOf(piece.back()->to()), std::move(piece)});
  }
}

void ChainReduction::compose(const PoseGraph& graph) {
  std::vector<RelativePoseFactor> composed_pieces(pieces_.size());
  Chunks(pieces_.size(), kPiecesAtOnce).forEach([&](std::size_t, Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      composed_pieces[i] = composed(pieces_[i].links);
      composed_pieces[i].nodes = {pieces_[i].first, pieces_[i].last};
    }
  });
  for (const RelativePoseFactor& piece : composed_pieces) reduced_.addFactor(piece);
  for (const Factor& factor : graph.factors()) {
    if (chainLink(factor) != nullptr) continue;
    const Factor kept = factor.renumbered(reduced_of_);
    reduced_.addFactor(kept.measurement, kept.kernel);
  }
}

std::vector<Pose> ChainReduction::expand(const std::vector<Pose>& reduced_poses) const {
  std::vector<Pose> poses(reduced_of_.size());
  for (std::size_t i = 0; i < kept_.size(); ++i) poses[kept_[i].value] = reduced_poses[i];
  Chunks(pieces_.size(), kPiecesAtOnce).forEach([&](std::size_t, Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Piece& piece = pieces_[i];
      const std::vector<Pose> inner =
          bentPiece(piece.links, reduced_poses[piece.first.value], reduced_poses[piece.last.value]);
      for (std::size_t k = 0; k < inner.size(); ++k) poses[piece.links[k]->to().value] = inner[k];
    }
  });
  return poses;
}

}  // namespace revisit_slam
