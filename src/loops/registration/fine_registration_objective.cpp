// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/registration/fine_registration_objective.h"

#include <Eigen/Cholesky>

namespace revisit_slam {
namespace {

/// Scale of the kernel, as part of the reach of the correspondences.
constexpr double kScale = 1.0 / 5.0;
/// A point without a plane says less about where it is than its distance does: its mean depends on
/// where the rays fell.
constexpr double kPointWeight = 0.1;
/// Share of the weights added to the diagonal; rotations act at the distance of a lever, metres.
constexpr double kDamping = 1e-4;
constexpr double kLever = 10.0;

}  // namespace

FineRegistrationObjective::FineRegistrationObjective(double distance)
    : kernel_(GemanMcClure::ofScale(kScale * distance)) {}

void FineRegistrationObjective::add(const Surfel& source, const Surfel& target, const SurfelPose& T,
                                    NormalEquations& equations) const {
  const Eigen::Vector3d p = source.point.cast<double>();
  const Eigen::Vector3d r =
      (T.R.transpose() * (T.R * source.point + T.t - target.point)).cast<double>();
  if (target.hasNormal() || source.hasNormal()) {
    const Eigen::Vector3d n =
        target.hasNormal() ? Eigen::Vector3d((T.R.transpose() * target.normal).cast<double>())
                           : Eigen::Vector3d(source.normal.cast<double>());
    const PointToPlane residual{p, n, n.dot(r)};
    equations.countMatch(residual.squared());
    equations.add(residual, kernel_.weight(residual.squared()));
  } else {
    const double squared = r.squaredNorm(), weight = kPointWeight * kernel_.weight(squared);
    equations.countMatch(squared);
    for (int axis = 0; axis < 3; ++axis)
      equations.add(PointToPlane{p, Eigen::Vector3d::Unit(axis), r[axis]}, weight);
  }
}

Tangent dampedStep(const NormalEquations& equations) {
  const double damping = kDamping * equations.weight();
  Matrix6 H = equations.H();
  H.diagonal().head<3>().array() += damping;
  H.diagonal().tail<3>().array() += damping * kLever * kLever;
  return H.ldlt().solve(-equations.g());
}

}  // namespace revisit_slam
