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

void writeEdges(std::ofstream& file, const std::vector<Constraint>& constraints,
                const std::vector<std::uint64_t>& ids) {
  for (const Constraint& constraint : constraints)
    file << "EDGE_SE3:QUAT " << ids[constraint.from.value] << ' ' << ids[constraint.to.value]
         << numbersOf(constraint.T_from_to) << numbersOf(informationToG2o(constraint.information))
         << '\n';
}

/// Scales rows and columns of the rotation.
Matrix6 scaleRotation(const Matrix6& information, double scale) {
  Tangent S = Tangent::Ones();
  S.tail<3>().setConstant(scale);
  return S.asDiagonal() * information * S.asDiagonal();
}

double g2oChi2(const std::vector<Constraint>& constraints, const std::vector<Pose>& poses) {
  double sum = 0.0;
  for (const Constraint& constraint : constraints) {
    const Pose E = constraint.T_from_to.inverse() *
                   (poses[constraint.from.value].inverse() * poses[constraint.to.value]);
    Tangent e;
    e << E.translation, (E.rotation.w() < 0.0 ? -1.0 : 1.0) * E.rotation.vec();
    sum += e.dot(informationToG2o(constraint.information) * e);
  }
  return sum;
}

}  // namespace

void writeG2o(const std::string& path, const G2oGraph& graph) {
  writeWholeFile(path, [&](const std::string& temporary) {
    std::ofstream file(temporary);
    for (std::size_t i = 0; i < graph.ids.size(); ++i)
      file << "VERTEX_SE3:QUAT " << graph.ids[i] << numbersOf(graph.graph.poses()[i]) << '\n';
    writeEdges(file, graph.graph.odometry(), graph.ids);
    writeEdges(file, graph.graph.loops(), graph.ids);
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
  return g2oChi2(graph.odometry(), poses) + g2oChi2(graph.loops(), poses);
}

}  // namespace revisit_slam
