// SPDX-License-Identifier: MIT
#include "revisit_slam/util/niceness.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace revisit_slam {

void setThreadNiceness(int niceness) {
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));  // on Linux each thread has its own
  (void)setpriority(PRIO_PROCESS, thread, niceness);
}

}  // namespace revisit_slam
