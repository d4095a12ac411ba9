// SPDX-License-Identifier: MIT
#include "revisit_slam/util/process_usage.h"

#include <stdlib.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

#include <ctime>
#include <fstream>

namespace revisit_slam {

namespace {

double secondsOn(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

double processCpuSeconds() {
  return secondsOn(CLOCK_PROCESS_CPUTIME_ID);
}

double threadCpuSeconds() {
  return secondsOn(CLOCK_THREAD_CPUTIME_ID);
}

double memoryMegabytes() {
  std::size_t all_pages = 0, resident_pages = 0;
  std::ifstream("/proc/self/statm") >> all_pages >> resident_pages;
  return static_cast<double>(resident_pages) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

double peakMemoryMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;
}

void shareMemoryAmongThreads() {
#ifdef __GLIBC__
  mallopt(M_ARENA_MAX, 1);
#endif
}

}  // namespace revisit_slam
