// SPDX-License-Identifier: MIT
#pragma once

namespace revisit_slam {

/// CPU time that all threads of this process have used, seconds.
double processCpuSeconds();

/// CPU time of the calling thread, seconds.
double threadCpuSeconds();

/// The memory that this process holds now, megabytes (10^6 bytes).
double memoryMegabytes();

/// The most memory that this process has held, megabytes (10^6 bytes).
double peakMemoryMegabytes();

}  // namespace revisit_slam
