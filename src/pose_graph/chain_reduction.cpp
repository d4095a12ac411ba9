// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/chain_reduction.h"

#include <limits>

#include "revisit_slam/pose_graph/gauge.h"
#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

constexpr NodeId kNone{std::numeric_limits<std::uint32_t>::max()};
constexpr std::size_t kPiecesAtOnce = 8;

/// How many links come into and go out of a node.
struct Degree {
  int in = 0, out = 0;
};

/// A node is inner to a chain when all it has is one link from before and one to after; a held node
/// is needed where it binds others.
std::vector<bool> neededNodes(const PoseGraph& graph) {
  std::vector<Degree> degrees(graph.poses().size());
  std::vector<bool> bound(graph.poses().size(), false), inner(graph.poses().size(), true);
  for (const Factor& factor : graph.factors()) {
    if (graph.isSettled(factor)) continue;
    for (const NodeId node : factor.nodes()) bound[node.value] = true;
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
  std::vector<bool> needed(inner.size());
  for (std::uint32_t i = 0; i < needed.size(); ++i)
    needed[i] = !inner[i] && (bound[i] || !graph.isHeld({i}));
  return needed;
}

}  // namespace

ChainReduction::ChainReduction(const PoseGraph& graph) : whole_(graph) {
  keepNodes();
  cutPieces();
  compose();
}

void ChainReduction::keepNodes() {
  const std::vector<bool> needed = neededNodes(whole_);
  reduced_of_.assign(needed.size(), kNone);
  for (std::uint32_t i = 0; i < needed.size(); ++i) {
    if (!needed[i]) continue;
    reduced_of_[i] = reduced_.addNode(whole_.poses()[i]);
    if (whole_.isHeld({i})) reduced_.hold(reduced_of_[i]);
    kept_.push_back(NodeId{i});
  }
}

void ChainReduction::cutPieces() {
  const auto reducedOf = [&](NodeId node) { return reduced_of_[node.value]; };
  std::vector<const RelativePoseFactor*> onwards(whole_.poses().size(), nullptr);  // of inner nodes
  std::vector<const RelativePoseFactor*> first;
  for (const Factor& factor : whole_.factors()) {
    const RelativePoseFactor* link = chainLink(factor);
    if (link == nullptr || whole_.isSettled(factor)) continue;
    if (reducedOf(link->from()) == kNone)
      onwards[link->from().value] = link;
    else
      first.push_back(link);
  }
  for (const RelativePoseFactor* link : first) {
    ChainPiece piece{link};
    while (reducedOf(piece.back()->to()) == kNone)
      piece.push_back(onwards[piece.back()->to().value]);
    pieces_.push_back({reducedOf(link->from()), reducedOf(piece.back()->to()), std::move(piece)});
  }
}

void ChainReduction::compose() {
  std::vector<RelativePoseFactor> composed_pieces(pieces_.size());
  Chunks(pieces_.size(), kPiecesAtOnce).forEach([&](std::size_t, Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      composed_pieces[i] = composed(pieces_[i].links);
      composed_pieces[i].nodes = {pieces_[i].first, pieces_[i].last};
    }
  });
  for (const RelativePoseFactor& piece : composed_pieces) reduced_.addFactor(piece);
  for (const Factor& factor : whole_.factors()) {
    if (chainLink(factor) != nullptr || whole_.isSettled(factor)) continue;
    const Factor kept = factor.renumbered(reduced_of_);
    reduced_.addFactor(kept.measurement, kept.kernel);
  }
}

std::vector<Pose> ChainReduction::expand(const std::vector<Pose>& reduced_poses) const {
  std::vector<Pose> poses = whole_.poses();
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
