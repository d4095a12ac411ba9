// SPDX-License-Identifier: MIT
#include "revisit_slam/io/g2o.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {
namespace {

/// The words and numbers of one line.
class Line {
 public:
  explicit Line(const std::string& text) : next_(text.c_str()) {}

  std::string word() {
    skipSpace();
    const char* begin = next_;
    while (*next_ != '\0' && std::isspace(static_cast<unsigned char>(*next_)) == 0) ++next_;
    return {begin, next_};
  }

  std::uint64_t id() {
    const std::string text = word();
    const bool digits = !text.empty() && text.size() < 20 &&
                        std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits) throw std::runtime_error("'" + text + "' is no id");
    return std::strtoull(text.c_str(), nullptr, 10);
  }

  double number() {
    char* end = nullptr;
    const double value = std::strtod(next_, &end);
    if (end == next_) throw std::runtime_error("a number is missing");
    if (!std::isfinite(value)) throw std::runtime_error("a number is not finite");
    next_ = end;
    return value;
  }

  void requireEnd() {
    skipSpace();
    if (*next_ != '\0') throw std::runtime_error("too much at '" + std::string(next_) + "'");
  }

 private:
  void skipSpace() {
    while (std::isspace(static_cast<unsigned char>(*next_)) != 0) ++next_;
  }

  const char* next_;
};

Pose readPose(Line& line) {
  Pose T;
  for (double& value : T.translation) value = line.number();
  for (double& value : T.rotation.coeffs()) value = line.number();
  if (!(T.rotation.norm() > 1e-3)) throw std::runtime_error("the quaternion has no length");
  T.rotation.normalize();
  return T;
}

Matrix6 readUpperTriangle(Line& line) {
  Matrix6 A;
  for (int row = 0; row < 6; ++row)
    for (int col = row; col < 6; ++col) A(row, col) = A(col, row) = line.number();
  return A;
}

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

/// Collects the lines, which may come in any order, and makes the graph of them.
class G2oReading {
 public:
  void read(const std::string& text, int number) {
    Line line(text);
    const std::string type = line.word();
    if (type.empty() || type[0] == '#' || type == "FIX" || type.rfind("PARAMS_", 0) == 0) return;
    if (type == "VERTEX_SE3:QUAT")
      addVertex(line);
    else if (type == "EDGE_SE3:QUAT")
      addEdge(line, number);
    else
      throw std::runtime_error("unknown type '" + type + "'");
    line.requireEnd();
  }

  std::size_t edges() const { return edges_.size(); }
  int lineOf(std::size_t edge) const { return edges_[edge].line; }

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

  void addEdgeTo(PoseGraph& graph, std::size_t index) const {
    const Edge& edge = edges_[index];
    const Constraint constraint{nodeOf(edge.from), nodeOf(edge.to), edge.T_from_to,
                                informationFromG2o(edge.information)};
    if (constraint.to.value == constraint.from.value + 1)
      graph.addOdometry(constraint);
    else
      graph.addLoop(constraint);
  }

 private:
  void addVertex(Line& line) {
    const std::uint64_t id = line.id();
    if (!nodes_.emplace(id, ScanId{}).second)
      throw std::runtime_error("vertex " + std::to_string(id) + " is there already");
    vertices_.push_back({id, readPose(line)});
  }

  void addEdge(Line& line, int number) {
    const std::uint64_t from = line.id(), to = line.id();
    const Pose T_from_to = readPose(line);
    edges_.push_back({from, to, T_from_to, readUpperTriangle(line), number});
  }

  ScanId nodeOf(std::uint64_t id) const {
    const auto found = nodes_.find(id);
    if (found == nodes_.end()) throw std::runtime_error("there is no vertex " + std::to_string(id));
    return found->second;
  }

  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::unordered_map<std::uint64_t, ScanId> nodes_;
};

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
         << numbersOf(constraint.T_from_to)
         << numbersOf(informationToG2o(constraint.information)) << '\n';
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

G2oGraph readG2o(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read the pose graph '" + path + "'");
  G2oReading reading;
  std::string text;
  int number = 0;
  try {
    while (std::getline(file, text)) reading.read(text, ++number);
    G2oGraph result = reading.vertices();
    for (std::size_t i = 0; i < reading.edges(); ++i) {
      number = reading.lineOf(i);
      reading.addEdgeTo(result.graph, i);
    }
    return result;
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ", line " + std::to_string(number) + ": " + error.what());
  }
}

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

Matrix6 informationFromG2o(const Matrix6& information) { return scaleRotation(information, 0.5); }
Matrix6 informationToG2o(const Matrix6& information) { return scaleRotation(information, 2.0); }

double g2oChi2(const PoseGraph& graph, const std::vector<Pose>& poses) {
  return g2oChi2(graph.odometry(), poses) + g2oChi2(graph.loops(), poses);
}

}  // namespace revisit_slam
