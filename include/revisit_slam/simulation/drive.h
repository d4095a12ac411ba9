// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "revisit_slam/simulation/scan_simulator.h"

namespace revisit_slam::simulation {

/// How many whole scans fit into the route, at most `max_scans` unless that is 0.
int scanCount(const Route& route, int max_scans = 0);

/// The first firing of a scan of the drive.
Stamp scanStart(const Route& route, int index);

/// Simulates scans 0 to count - 1 on several threads and hands them over in order, one at a time.
/// What is handed over does not depend on the number of threads.
/// @param threads 0: as many as the machine has.
void simulateDrive(const ScanSimulator& simulator, const Route& route, int count, int threads,
                   const std::function<void(int index, const SimulatedScan&)>& consume);

}  // namespace revisit_slam::simulation
