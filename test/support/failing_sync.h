// SPDX-License-Identifier: MIT
#pragma once

#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

namespace revisit_slam {

/// As long as one of these lives, no file of the process can be handed to the disk.
class FailingSync {
 public:
  FailingSync() { isOn() = true; }
  ~FailingSync() { isOn() = false; }
  FailingSync(const FailingSync&) = delete;
  FailingSync& operator=(const FailingSync&) = delete;

  static std::atomic<bool>& isOn() {
    static std::atomic<bool> is_on{false};
    return is_on;
  }
};

}  // namespace revisit_slam

/// Of the whole program, in which this header may stand once: what a disk answers that has a fault,
/// or a network where a quota ends.
extern "C" int fdatasync(int file) {
  if (!revisit_slam::FailingSync::isOn()) return static_cast<int>(syscall(SYS_fdatasync, file));
  errno = EIO;
  return -1;
}
