// SPDX-License-Identifier: MIT
#include <Eigen/Eigenvalues>
#include <cmath>
#include <fstream>
#include <unordered_map>

#include "g2o_line.h"
#include "revisit_slam/io/g2o.h"

namespace revisit_slam {
namespace {

struct Vertex {
  std::uint64_t id;
  Pose T_map_node;
};

struct Edge {
  std::uint64_t from, to;
  Pose T_from_to;
  Matrix6 information;
  int line;
};

struct Held {
  std::uint64_t id;
  int line;
};

/// Whether no direction has a negative weight, but for rounding of the file's digits.
bool isInformation(const Matrix6& matrix) {
  constexpr double kRounding = 1e-6;
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(matrix, Eigen::EigenvaluesOnly);
  const Tangent& eigenvalues = solver.eigenvalues();  // ascending
  return eigenvalues[0] >= -kRounding * std::abs(eigenvalues[5]);
}

/// Collects the lines, which may come in any order, and makes the graph of them.
class G2oReading {
 public:
  void read(const std::string& text, int number) {
    if (text.find('\0') != std::string::npos) throw std::runtime_error("a byte of no text");
    G2oLine line(text);
    const std::string type = line.word();
    if (type.empty() || type[0] == '#' || type.rfind("PARAMS_", 0) == 0) return;
    if (type == "FIX")
      addHeld(line, number);
    else if (type == "VERTEX_SE3:QUAT")
      addVertex(line);
    else if (type == "EDGE_SE3:QUAT")
      addEdge(line, number);
    else
      throw std::runtime_error("unknown type '" + type + "'");
    line.requireEnd();
  }

  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Held>& held() const { return held_; }

  G2oGraph vertices() {
    std::sort(vertices_.begin(), vertices_.end(),
              [](const Vertex& a, const Vertex& b) { return a.id < b.id; });
    G2oGraph result;
    for (const Vertex& vertex : vertices_) {
      nodes_[vertex.id] = result.graph.addNode(vertex.T_map_node);
      result.ids.push_back(vertex.id);
    }
    return result;
  }

  RelativePoseFactor factorOf(const Edge& edge) const {
    return {
        {nodeOf(edge.from), nodeOf(edge.to)}, edge.T_from_to, informationFromG2o(edge.information)};
  }

  NodeId nodeOf(std::uint64_t id) const {
    const auto found = nodes_.find(id);
    if (found == nodes_.end()) throw std::runtime_error("there is no vertex " + std::to_string(id));
    return found->second;
  }

 private:
  void addHeld(G2oLine& line, int number) {
    held_.push_back({line.id(), number});
    while (!line.isAtEnd()) held_.push_back({line.id(), number});
  }

  void addVertex(G2oLine& line) {
    const std::uint64_t id = line.id();
    if (!nodes_.emplace(id, NodeId{}).second)
      throw std::runtime_error("vertex " + std::to_string(id) + " is there already");
    vertices_.push_back({id, line.pose()});
  }

  void addEdge(G2oLine& line, int number) {
    const std::uint64_t from = line.id(), to = line.id();
    if (from == to) throw std::runtime_error("an edge from a vertex to itself");
    const Pose T_from_to = line.pose();
    const Matrix6 information = line.symmetric();
    if (!isInformation(information))
      throw std::runtime_error("the information matrix has a negative eigenvalue");
    edges_.push_back({from, to, T_from_to, information, number});
  }

  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<Held> held_;
  std::unordered_map<std::uint64_t, NodeId> nodes_;
};

}  // namespace

G2oGraph readG2o(const std::string& path, const RobustKernel& loop_kernel) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read the pose graph '" + path + "'");
  G2oReading reading;
  std::string text;
  int number = 0;
  try {
    while (std::getline(file, text)) reading.read(text, ++number);
    G2oGraph result = reading.vertices();
    if (result.ids.empty()) throw std::runtime_error("there is no vertex");
    for (const Held& held : reading.held()) {
      number = held.line;
      result.graph.hold(reading.nodeOf(held.id));
    }
    std::vector<RelativePoseFactor> loops;
    for (const Edge& edge : reading.edges()) {
      number = edge.line;
      const RelativePoseFactor factor = reading.factorOf(edge);
      if (factor.to().value == factor.from().value + 1)
        result.graph.addFactor(factor);
      else
        loops.push_back(factor);
    }
    for (const RelativePoseFactor& loop : loops) result.graph.addFactor(loop, loop_kernel);
    return result;
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ", line " + std::to_string(number) + ": " + error.what());
  }
}

}  // namespace revisit_slam
