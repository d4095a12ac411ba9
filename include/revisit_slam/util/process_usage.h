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

/// Lets all threads take memory from one place, where the C library is glibc: what one has given
/// back the others can use. To be called before there are threads.
void shareMemoryAmongThreads();

}  // namespace revisit_slam
