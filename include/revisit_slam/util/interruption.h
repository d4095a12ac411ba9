// SPDX-License-Identifier: MIT
#pragma once

namespace revisit_slam {

/// From here on the first SIGINT or SIGTERM does not end the program but is kept for it to see; the
/// next one ends it.
void catchInterruption();

/// The signal that has come; 0: none.
int interruption();

}  // namespace revisit_slam
