// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "revisit_slam/information/perturbation_design.h"
#include "revisit_slam/information/registration_problem.h"

namespace revisit_slam {

/// Evaluates the objective of a registration problem at the perturbations of one design.
class ObjectiveSampling {
 public:
  /// `index`: the place of the design among those that the problem was gathered for.
  ObjectiveSampling(const PerturbationDesign& design, std::size_t index);

  /// chi at each sample and, last, at the unperturbed pose; m^2, summed over the points of the
  /// problem. Runs in the current TBB arena, with the same bits for any number of threads.
  Eigen::VectorXd evaluate(const RegistrationProblem& problem) const;

 private:
  void evaluateChunk(const RegistrationProblem& problem, std::size_t chunk, double* sums) const;

  std::size_t index_;
  std::size_t samples_;  // the unperturbed pose included
  std::size_t padded_;   // samples_ rounded up for whole vector registers
  /// Displacement of a point p by sample m: u = A_m p + a_m. Rows 0-8: A, 9-11: a; padded_ columns.
  std::vector<float> displacement_;
};

}  // namespace revisit_slam
