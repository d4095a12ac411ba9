// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/loop_markers.h"

#include "revisit_slam/ros/messages/display.h"

namespace revisit_slam {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Full colours: those of maps are paler (colourOf).
const auto kMagenta = colour(1.0f, 0.0f, 1.0f), kCyan = colour(0.0f, 1.0f, 1.0f),
           kOrange = colour(1.0f, 0.5f, 0.0f), kRed = colour(1.0f, 0.0f, 0.0f),
           kGreen = colour(0.0f, 1.0f, 0.0f), kGrey = colour(0.6f, 0.6f, 0.6f);
constexpr double kRaise = 4.0;  // m, so that edges are above the path and the points of the map

std_msgs::ColorRGBA colourOfEdge(const LoopEdge& edge, double min_inlier_weight) {
  if (edge.state == LoopState::rejected) return kRed;
  if (edge.state == LoopState::disabled) return kGrey;
  if (edge.weight < min_inlier_weight) return kOrange;
  return edge.loop.origin == LoopOrigin::appearance ? kMagenta : kCyan;
}

/// "3", and what is unusual about its state.
std::string textOf(const LoopEdge& edge, double min_inlier_weight) {
  const std::string number = std::to_string(edge.id.value);
  if (edge.state == LoopState::rejected || edge.state == LoopState::disabled)
    return number + " " + toString(edge.state);
  return edge.weight < min_inlier_weight ? number + " down-weighted" : number;
}

/// Lines from place to place, each with a text in its middle.
class Lines {
 public:
  Lines(const std::string& frame, const std::string& name, double width)
      : frame_(frame),
        name_(name),
        lines_(makeMarker(frame, name, 0, Marker::LINE_LIST, width, kGrey)),
        ends_(makeMarker(frame, name + "_ends", 0, Marker::SPHERE_LIST, 2.0 * width, kGrey)) {}

  void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
           const std_msgs::ColorRGBA& colour, const std::string& text) {
    const Eigen::Vector3d raise(0.0, 0.0, kRaise);
    for (const Eigen::Vector3d& end : {from, to})
      for (Marker* marker : {&lines_, &ends_}) {
        marker->points.push_back(toPointMessage(end + raise));
        marker->colors.push_back(colour);
      }
    if (text.empty()) return;  // rviz takes an empty one for a fault
    texts_.push_back(makeText(frame_, name_ + "_texts", static_cast<int>(texts_.size()), 2.5,
                              0.5 * (from + to) + 1.5 * raise, text));
  }

  void addTo(MarkerArray& array) const {
    if (lines_.points.empty()) return;
    array.markers.push_back(lines_);
    array.markers.push_back(ends_);
    array.markers.insert(array.markers.end(), texts_.begin(), texts_.end());
  }

 private:
  std::string frame_, name_;
  Marker lines_, ends_;
  std::vector<Marker> texts_;
};

}  // namespace

MarkerArray toLoopEdges(const SlamGraph& graph, double min_inlier_weight,
                        const std::string& frame) {
  Lines lines(frame, "loops", 0.8);
  for (const LoopEdge& edge : graph.loops()) {
    const Constraint& constraint = edge.loop.constraint;
    lines.add(graph.pose(constraint.from).translation, graph.pose(constraint.to).translation,
              colourOfEdge(edge, min_inlier_weight), textOf(edge, min_inlier_weight));
  }
  MarkerArray array;
  array.markers.push_back(deleteAll());
  lines.addTo(array);
  return array;
}

MarkerArray toLoopCandidates(const std::vector<LoopSearchResult>& searches,
                             const std::function<Pose(LocalMapId)>& T_map_local,
                             const std::function<Pose(SubmapId)>& T_map_submap,
                             const std::string& frame) {
  Lines alike(frame, "alike", 0.1), pairs(frame, "pairs", 0.2);
  for (const LoopSearchResult& search : searches) {
    for (const PlaceMatch& match : search.candidates)
      alike.add(T_map_local(match.target).translation, T_map_local(match.source).translation, kGrey,
                std::to_string(match.inliers));
    for (const LoopProposal& proposal : search.proposals)
      pairs.add(T_map_submap(proposal.loop.target).translation,
                T_map_submap(proposal.loop.source).translation,
                proposal.verdict.isAccepted() ? kGreen : kRed, proposal.verdict.reason());
  }
  MarkerArray array;
  array.markers.push_back(deleteAll());
  alike.addTo(array);
  pairs.addTo(array);
  return array;
}

}  // namespace revisit_slam
