// SPDX-License-Identifier: MIT
// Files of their own: pose graphs, points, trajectories, parameters.
#include "datasets/pcd_cloud.h"
#include "readers.h"
#include "revisit_slam/io/g2o.h"
#include "revisit_slam/io/parameter_file.h"
#include "revisit_slam/io/pcd.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/session/session_info.h"
#include "revisit_slam/slam/slam_config.h"
#include "scratch.h"

namespace revisit_slam::fuzz {
namespace {

const Scratch& scratch() {
  static const Scratch folder;
  return folder;
}

/// Whatever one reader says, the other is asked too.
template <typename First, typename Second>
void both(const First& first, const Second& second) {
  try {
    first();
  } catch (const std::exception&) {
  }
  second();
}

std::string pcdOf(const std::string& encoding, const std::string& points) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z t\nSIZE 4 4 4 4\nTYPE F F F U\nWIDTH 2\nHEIGHT 1\n"
         "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA " +
         encoding + "\n" + points;
}

}  // namespace

void readPoseGraph(const std::string& bytes) {
  const G2oGraph read = readG2o(scratch().with("a.g2o", bytes));
  g2oChi2(read.graph, read.graph.poses());
}

Seeds seedsOfPoseGraph() {
  const std::string information = "1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n";
  return {
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 0 0 0 0 0 1\n# text\nFIX 0\n"
      "VERTEX_SE3:QUAT 2 1 0 0 0 0 0 1\nPARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\n"
      "EDGE_SE3:QUAT 0 1 1 0 0 0 0 0 1 " +
      information + "EDGE_SE3:QUAT 2 0 1 0 0 0 0 0 1 " + information};
}

void readPointFile(const std::string& bytes) {
  const std::string path = scratch().with("a.pcd", bytes);
  both([&] { readPcd(path); }, [&] { readPcdPoints(path); });
}

Seeds seedsOfPointFile() {
  Seeds seeds{pcdOf("ascii", "1 2 3 4\n5 6 7 8\n"), pcdOf("binary", std::string(32, 'a'))};
  // Compressed: lengths, and letters that stand for themselves.
  std::string compressed{33, 0, 0, 0, 32, 0, 0, 0, 31};
  seeds.push_back(pcdOf("binary_compressed", compressed + std::string(32, 'b')));
  writePcd(scratch().file("own.pcd"), {{1, 2, 3}, {4, 5, 6}});
  seeds.push_back(bytesOfFile(scratch().file("own.pcd")));
  return seeds;
}

void readTrajectories(const std::string& bytes) {
  const std::string path = scratch().with("a.txt", bytes);
  both([&] { readTum(path); }, [&] { readKitti(path); });
}

Seeds seedsOfTrajectories() {
  return {"# stamp x y z\n1700000000.123456789 1 2 3 0 0 0 1\n1.7e9 1 2 3 0 0 0.6 0.8\n",
          "1 0 0 4 0 1 0 5 0 0 1 6\n0 -1 0 4 1 0 0 5 0 0 1 6\n"};
}

void readParameters(const std::string& bytes) {
  const std::string path = scratch().with("a.yaml", bytes);
  both([&] { readSessionInfo(path); },
       [&] {
         SlamConfig config;
         assign(parametersOf(config), readParameterFile(path));
       });
}

Seeds seedsOfParameters() {
  return {
      "odometry:\n  max_range: 80  # metres\n  map: {voxel_size: 0.5}\nloops: {enabled: false}\n",
      "a: &a {b: 1}\nc: *a\nframes: {base: 'x y', odom: \"o\"}\n",
      bytesOfFile(REVISIT_SLAM_SOURCE_FOLDER "/test/session/format_1/session.yaml"),
      bytesOfFile(REVISIT_SLAM_SOURCE_FOLDER "/cfg/paper.yaml")};
}

}  // namespace revisit_slam::fuzz
