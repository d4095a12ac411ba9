// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/factor.h"

namespace revisit_slam {

FactorNodes Factor::nodes() const {
  return std::visit(
      [](const auto& measured) {
        return FactorNodes(measured.nodes.data(), measured.nodes.size());
      },
      measurement);
}

double Factor::chi2(const std::vector<Pose>& poses) const {
  return std::visit(
      [&](const auto& measured) {
        const auto e = measured.error(posesOf(measured, poses));
        return e.dot(measured.information * e);
      },
      measurement);
}

bool Factor::isFinite() const {
  return std::visit([](const auto& measured) { return measured.isFinite(); }, measurement);
}

Factor Factor::renumbered(const std::vector<NodeId>& new_ids) const {
  Factor factor = *this;
  std::visit(
      [&](auto& measured) {
        for (NodeId& node : measured.nodes) node = new_ids[node.value];
      },
      factor.measurement);
  return factor;
}

}  // namespace revisit_slam
