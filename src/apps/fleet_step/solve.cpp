// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <set>

#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/session/keyposes.h"
#include "revisit_slam/slam/joint_graph.h"
#include "revisit_slam/util/process_usage.h"
#include "steps.h"

namespace revisit_slam {
namespace {

constexpr double kDegrees = 180.0 / M_PI;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", value);
  return text;
}

/// Which sessions lie in one map: that of the first of them.
std::string sessionTable(const JointGraph& joint) {
  struct Crossings {
    std::size_t loops = 0;
    std::set<std::size_t> sessions;
  };
  std::vector<Crossings> crossings(joint.sessions().size());
  for (const LoopEdge& edge : joint.loopsBetweenSessions()) {
    if (edge.state != LoopState::active) continue;
    const std::size_t source = edge.loop.source.session.value,
                      target = edge.loop.target.session.value;
    for (const auto& [one, other] : {std::pair(source, target), std::pair(target, source)}) {
      ++crossings[one].loops;
      crossings[one].sessions.insert(other);
    }
  }
  std::string text = "session,map,submaps,length,own_loops,loops,sessions\n";
  for (std::size_t s = 0; s < joint.sessions().size(); ++s) {
    const SessionSummary& session = joint.sessions()[s];
    text += session.name + "," + joint.sessions()[joint.groupOf(s)].name + "," +
            std::to_string(session.submaps.size()) + "," + number(session.length) + "," +
            std::to_string(session.loops.size()) + "," + std::to_string(crossings[s].loops) + "," +
            std::to_string(crossings[s].sessions.size()) + "\n";
  }
  return text;
}

std::string loopTable(const JointGraph& joint) {
  std::string text =
      "source,source_submap,target,target_submap,state,weight,fitness,inliers,translation_error,"
      "rotation_error,x,y,z,qx,qy,qz,qw\n";
  for (const LoopEdge& edge : joint.loopsBetweenSessions()) {
    const Pose error = joint.residual(edge);
    const Pose& T = edge.loop.constraint.T_from_to;
    const auto name = [&](SubmapId id) {
      return joint.sessions()[id.session.value].name + "," + std::to_string(id.value) + ",";
    };
    text += name(edge.loop.source) + name(edge.loop.target) + toString(edge.state);
    for (const double value :
         {edge.weight, edge.loop.fitness, static_cast<double>(edge.loop.inliers),
          error.translation.norm(), error.angle() * kDegrees, T.translation.x(), T.translation.y(),
          T.translation.z(), T.rotation.x(), T.rotation.y(), T.rotation.z(), T.rotation.w()})
      text += "," + number(value);
    text += "\n";
  }
  return text;
}

}  // namespace

void solveJointly(const SolveOptions& options, const SlamConfig& config) {
  std::vector<SessionSummary> sessions;
  for (const std::string& path : options.summaries) {
    sessions.push_back(readSummary(path));
    sessions.back().places = {};  // have done their part
  }
  std::vector<SessionCrossing> crossings;
  for (const std::string& path : options.crossings) crossings.push_back(readCrossing(path));
  const JointGraph joint(config, std::move(sessions), crossings);
  std::filesystem::create_directories(options.out + "/keyposes");
  std::set<std::size_t> groups;
  for (std::size_t s = 0; s < joint.sessions().size(); ++s) {
    groups.insert(joint.groupOf(s));
    writeWholeText(options.out + "/keyposes/" + joint.sessions()[s].name + ".csv",
                   keyposeText(joint.keyposes(s)));
  }
  writeWholeText(options.out + "/loops.csv", loopTable(joint));
  writeWholeText(options.out + "/sessions.csv", sessionTable(joint));
  std::cout << joint.sessions().size() << " sessions in " << groups.size() << " maps, "
            << joint.loopsBetweenSessions().size() << " loops between them, " << joint.leftOut()
            << " left out, " << joint.rounds() << " rounds, "
            << static_cast<int>(peakMemoryMegabytes()) << " MB\n";
}

}  // namespace revisit_slam
