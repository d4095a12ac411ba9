// SPDX-License-Identifier: MIT
#include "revisit_slam/types/registration_result.h"

namespace revisit_slam {

const char* toString(RegistrationOutcome outcome) {
  switch (outcome) {
    case RegistrationOutcome::converged:
      return "converged";
    case RegistrationOutcome::max_iterations:
      return "stopped at the largest number of iterations";
    case RegistrationOutcome::too_few_correspondences:
      return "too few correspondences";
    case RegistrationOutcome::no_fit:
      return "the scan does not fit the map";
    case RegistrationOutcome::map_empty:
      return "first scan";
  }
  return "unknown";
}

}  // namespace revisit_slam
