// SPDX-License-Identifier: MIT
#pragma once

namespace revisit_slam {

/// CPU time that all threads of this process have used, seconds.
double processCpuSeconds();

/// The most memory that this process has held, megabytes (10^6 bytes).
double peakMemoryMegabytes();

}  // namespace revisit_slam
