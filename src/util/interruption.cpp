// SPDX-License-Identifier: MIT
#include "revisit_slam/util/interruption.h"

#include <csignal>
#include <initializer_list>

namespace revisit_slam {
namespace {

volatile std::sig_atomic_t received = 0;

void keep(int signal) {
  received = signal;
  for (const int each : {SIGINT, SIGTERM}) std::signal(each, SIG_DFL);
}

}  // namespace

void catchInterruption() {
  for (const int each : {SIGINT, SIGTERM}) std::signal(each, keep);
}

int interruption() {
  return received;
}

}  // namespace revisit_slam
