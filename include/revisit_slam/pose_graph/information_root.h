// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// A matrix U with U^T U = information, so that |U e|^2 = e^T information e. Where the information
/// is only semi-definite, its negative eigenvalues (round-off) count as zero. Of an asymmetric
/// matrix the symmetric part counts, which is all that a quadratic form sees.
Matrix6 informationRoot(const Matrix6& information);

}  // namespace revisit_slam
