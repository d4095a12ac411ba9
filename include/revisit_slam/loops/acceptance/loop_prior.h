// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include "revisit_slam/types/loop_edge.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/session_offsets.h"
#include "revisit_slam/types/submap.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// How far the odometry is expected to drift, and how far a loop may deviate from that.
struct DriftConfig {
  double max_deviation = 3.0;
  double base = 0.3;
  double rate = 0.01;
  double weak_rate = 0.05;
  double vertical_share = 0.3;
  double rotation = 1.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_deviation", max_deviation, Range{0.0, 1000.0}, "sigma",
      "largest deviation of a loop from where the graph expects it, in standard deviations of the "
      "odometry's drift along the path through the graph with the least drift; 0: not checked. "
      "Raise it if right loops are rejected after long drives; lower it if wrong loops of places "
      "that look alike are accepted");
    v("base", base, Range{0.0, 100.0}, "m",
      "standard deviation of a loop's position before any drift, as submaps are bent "
      "themselves. Raise it if right loops are rejected after short drives; lower it if wrong "
      "ones are accepted");
    v("rate", rate, Range{0.0, 1.0}, "",
      "standard deviation of the drift, in metres for each metre travelled. Raise it if the "
      "odometry drifts more than this; lower it if it drifts less");
    v("weak_rate", weak_rate, Range{0.0, 10.0}, "",
      "standard deviation of the drift that is added for each metre travelled where scans hardly "
      "constrain the pose in the plane, or in height. Raise it if right loops behind tunnels are "
      "rejected; lower it if wrong ones are accepted");
    v("vertical_share", vertical_share, Range{0.0, 10.0}, "",
      "drift in height where scans constrain it, as a share of the drift in the plane, but no less "
      "than base. Raise it if right loops are rejected for their height; lower it if storeys are "
      "taken for each other");
    v("rotation", rotation, Range{0.0, 180.0}, "deg/m",
      "drift in rotation for each metre of drift in the plane. Raise it if right loops are "
      "rejected for their rotation; lower it if wrong ones are accepted");
  }
};

/// Standard deviations, m; infinite where nothing is known.
struct Drift {
  double plane = std::numeric_limits<double>::infinity();
  double height = std::numeric_limits<double>::infinity();
};

/// What is known of where one submap lies in another before they are registered.
struct LoopPrior {
  Pose T_target_source;
  Drift drift;

  /// How many standard deviations a pose is from it, 0 where nothing is known. The height is that
  /// along the z axis of the target submap.
  double deviation(const Pose& T_target_source, const DriftConfig& config) const;
};

/// How far the graph can be off between submaps: the drift of the odometry along the shortest way
/// from one to the other, which may take the loops that the graph has taken. Shortest: with the
/// least drift in the plane.
class GraphDrift {
 public:
  /// `submaps` of each session by number, session after session.
  GraphDrift(std::vector<SubmapPtr> submaps, const std::vector<LoopEdge>& loops,
             const DriftConfig& config);

  /// From a submap to each of all, in their order.
  std::vector<Drift> from(SubmapId submap) const;
  /// From one to the other; looks no farther than that.
  Drift between(SubmapId a, SubmapId b) const;

 private:
  struct Step {
    std::size_t to;
    Drift drift;
  };

  std::vector<Drift> search(std::size_t begin, std::size_t until) const;

  Drift base_;
  SessionOffsets<SubmapId> submaps_;
  std::vector<std::vector<Step>> steps_;  // from each submap
};

}  // namespace revisit_slam
