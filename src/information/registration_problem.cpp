// SPDX-License-Identifier: MIT
#include "revisit_slam/information/registration_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "revisit_slam/util/chunks.h"

namespace revisit_slam {
namespace {

/// Floats hold the few metres between a point and its candidates to better than this.
constexpr float kRounding = 1e-5f;

/// How far the perturbations of a design move one point p from where it is registered:
/// u = t + r x p + higher orders.
struct Reach {
  float along_axes;     // per axis, from translation
  float about_axes;     // per axis, rad
  float higher_orders;  // m
  float farthest;       // m
};

Reach reachOf(const PerturbationDesign& design, const Eigen::Vector3f& p) {
  const double distance = p.norm();
  const double t = design.longestTranslation(), r = design.longestRotation();
  const double higher_orders = 0.5 * r * (r * distance + t) * (1.0 + r);
  return {static_cast<float>(design.translationRange()), static_cast<float>(design.rotationRange()),
          static_cast<float>(higher_orders) + kRounding,
          static_cast<float>(t + r * distance + higher_orders) + kRounding};
}

/// Whether some u within reach is nearer to c than to the nearest candidate, all relative to the
/// registered point: u (c - nearest) > (|c|^2 - |nearest|^2) / 2.
bool canBecomeNearest(const Eigen::Vector3f& c, const Eigen::Vector3f& nearest,
                      const Eigen::Vector3f& p, const Reach& reach) {
  const Eigen::Vector3f d = c - nearest;
  const float needed = 0.5f * (c.squaredNorm() - nearest.squaredNorm());
  const float possible = reach.along_axes * d.lpNorm<1>() +
                         reach.about_axes * p.cross(d).lpNorm<1>() + reach.higher_orders * d.norm();
  return possible + kRounding >= needed;
}

/// Adds the candidates of one point, out of the map points around it.
void addCandidates(const Points& around, const Eigen::Vector3f& nearest, const Eigen::Vector3f& p,
                   const Reach& reach, float tau, Candidates& candidates) {
  // Farther than either, a point is beyond tau of all samples, or behind the nearest one for all.
  const float radius =
      std::min(reach.farthest + tau, nearest.norm() + 2.0f * reach.farthest) + kRounding;
  for (const Eigen::Vector3f& c : around)
    if (c.squaredNorm() <= radius * radius && canBecomeNearest(c, nearest, p, reach))
      candidates.relative_base.push_back(c);
}

/// At most `max_points` points, evenly spread over the order of the scan.
Points thinned(const Points& points, std::size_t max_points) {
  if (points.size() <= max_points) return points;
  Points kept;
  kept.reserve(max_points);
  for (std::size_t i = 0; i < max_points; ++i)
    kept.push_back(points[i * points.size() / max_points]);
  return kept;
}

class Gatherer {
 public:
  Gatherer(const LocalVoxelMap& map, const Pose& T_odom_base, double tau,
           const std::vector<PerturbationDesign>& designs)
      : map_(map),
        R_odom_base_(T_odom_base.rotationMatrix()),
        R_base_odom_(R_odom_base_.transpose().cast<float>()),
        t_odom_base_(T_odom_base.translation),
        tau_(tau),
        designs_(designs) {}

  std::vector<Candidates> gather(const Points& points, Chunk chunk) const {
    std::vector<Candidates> candidates(designs_.size());
    std::vector<Reach> reaches(designs_.size());
    Points around;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      float farthest = 0.0f;
      for (std::size_t k = 0; k < designs_.size(); ++k) {
        reaches[k] = reachOf(designs_[k], points[i]);
        farthest = std::max(farthest, reaches[k].farthest);
      }
      const Eigen::Vector3f nearest = lookAround(points[i], farthest, around);
      for (std::size_t k = 0; k < designs_.size(); ++k) {
        addCandidates(around, nearest, points[i], reaches[k], static_cast<float>(tau_),
                      candidates[k]);
        candidates[k].begin.push_back(
            static_cast<std::uint32_t>(candidates[k].relative_base.size()));
      }
    }
    return candidates;
  }

 private:
  /// Collects the map points that any perturbation can bring near, relative to the point, and
  /// returns the nearest of them.
  Eigen::Vector3f lookAround(const Eigen::Vector3f& point, double farthest, Points& around) const {
    const Eigen::Vector3d point_odom = R_odom_base_ * point.cast<double>() + t_odom_base_;
    double radius = farthest + tau_;
    Neighbour neighbour;
    if (map_.nearest(point_odom, map_.voxelSize(), neighbour))
      radius = std::min(radius, neighbour.distance + 2.0 * farthest + kRounding);
    around.clear();
    Eigen::Vector3f nearest = Eigen::Vector3f::Zero();
    float smallest = std::numeric_limits<float>::max();
    map_.forEachAround(point_odom, radius,
                       [&](const Eigen::Vector3f& relative_odom, float squared) {
                         around.push_back(R_base_odom_ * relative_odom);
                         if (squared < smallest) {
                           smallest = squared;
                           nearest = around.back();
                         }
                       });
    return nearest;
  }

  const LocalVoxelMap& map_;
  const Eigen::Matrix3d R_odom_base_;
  const Eigen::Matrix3f R_base_odom_;
  const Eigen::Vector3d t_odom_base_;
  const double tau_;
  const std::vector<PerturbationDesign>& designs_;
};

}  // namespace

RegistrationProblem gatherProblem(const Points& points_base, const LocalVoxelMap& map,
                                  const Pose& T_odom_base, double tau, std::size_t max_points,
                                  const std::vector<PerturbationDesign>& designs) {
  RegistrationProblem problem;
  problem.points_base = thinned(points_base, max_points);
  problem.tau = std::min(tau, map.voxelSize());
  problem.scale = static_cast<double>(points_base.size()) /
                  static_cast<double>(std::max<std::size_t>(1, problem.points_base.size()));
  const Gatherer gatherer(map, T_odom_base, problem.tau, designs);
  const Chunks chunks(problem.points_base.size(), RegistrationProblem::kChunkLength);
  problem.chunks.resize(chunks.size());
  chunks.forEach([&](std::size_t index, Chunk chunk) {
    problem.chunks[index] = gatherer.gather(problem.points_base, chunk);
  });
  return problem;
}

}  // namespace revisit_slam
