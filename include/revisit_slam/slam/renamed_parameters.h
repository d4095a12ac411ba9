// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Parameters of SlamConfig that had another name in the release before: the old name, the new one.
/// A pair is removed one release later.
inline const RenamedParameters kRenamedParameters{};

}  // namespace revisit_slam
