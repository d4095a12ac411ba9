// SPDX-License-Identifier: MIT
#include "revisit_slam/io/g2o.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {
namespace {

std::string numbersOf(const Pose& T) {
  const Eigen::Vector3d& t = T.translation;
  const Eigen::Quaterniond& q = T.rotation;
  char text[256];
  std::snprintf(text, sizeof(text), " %.17g %.17g %.17g %.17g %.17g %.17g %.17g", t.x(), t.y(),
                t.z(), q.x(), q.y(), q.z(), q.w());
  return text;
}

std::string numbersOf(const Matrix6& information) {
  std::string text;
  char number[32];
  for (int row = 0; row < 6; ++row)
    for (int col = row; col < 6; ++col) {
      std::snprintf(number, sizeof(number), " %.17g", information(row, col));
      text += number;
    }
  return text;
}

std::vector<const RelativePoseFactor*> edgesOf(const PoseGraph& graph) {
  std::vector<const RelativePoseFactor*> edges;
  for (const Factor& factor : graph.factors())
    if (const auto* edge = std::get_if<RelativePoseFactor>(&factor.measurement))
      edges.push_back(edge);
  return edges;
}

void writeEdges(std::ofstream& file, const G2oGraph& graph) {
  const std::vector<const RelativePoseFactor*> edges = edgesOf(graph.graph);
  for (const RelativePoseFactor* edge : edges)
    file << "EDGE_SE3:QUAT " << graph.ids[edge->from().value] << ' ' << graph.ids[edge->to().value]
         << numbersOf(edge->T_from_to) << numbersOf(informationToG2o(edge->information)) << '\n';
  const std::size_t others = graph.graph.factors().size() - edges.size();
  if (others > 0) file << "# without " << others << " factors that are no relative poses\n";
}

/// Scales rows and columns of the rotation.
Matrix6 scaleRotation(const Matrix6& information, double scale) {
  Tangent S = Tangent::Ones();
  S.tail<3>().setConstant(scale);
  return S.asDiagonal() * information * S.asDiagonal();
}

}  // namespace

void writeG2o(const std::string& path, const G2oGraph& graph) {
  writeWholeFile(path, [&](const std::string& temporary) {
    std::ofstream file(temporary);
    for (std::size_t i = 0; i < graph.ids.size(); ++i)
      file << "VERTEX_SE3:QUAT " << graph.ids[i] << numbersOf(graph.graph.poses()[i]) << '\n';
    for (std::uint32_t i = 0; i < graph.ids.size(); ++i)
      if (graph.graph.isHeld({i})) file << "FIX " << graph.ids[i] << '\n';
    writeEdges(file, graph);
    if (!file.flush()) throw std::runtime_error("cannot write the pose graph '" + path + "'");
  });
}

Matrix6 informationFromG2o(const Matrix6& information) {
  return scaleRotation(information, 0.5);
}
Matrix6 informationToG2o(const Matrix6& information) {
  return scaleRotation(information, 2.0);
}

double g2oChi2(const PoseGraph& graph, const std::vector<Pose>& poses) {
  double sum = 0.0;
  for (const RelativePoseFactor* edge : edgesOf(graph)) {
    const Pose E =
        edge->T_from_to.inverse() * (poses[edge->from().value].inverse() * poses[edge->to().value]);
    Tangent e;
    e << E.translation, (E.rotation.w() < 0.0 ? -1.0 : 1.0) * E.rotation.vec();
    sum += e.dot(informationToG2o(edge->information) * e);
  }
  return sum;
}

}  // namespace revisit_slam
