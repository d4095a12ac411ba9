// SPDX-License-Identifier: MIT
#include "revisit_slam/io/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "revisit_slam/io/file_name.h"

namespace revisit_slam {
namespace {

std::string lockOf(const std::string& folder) {
  return folder + "/lock";
}

}  // namespace

FolderLock::FolderLock(const std::string& folder) : path_(lockOf(folder)) {
  bool is_held = true;
  for (int attempt = 0; attempt < 10 && is_held; ++attempt) {
    if (file_ >= 0) ::close(file_);
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0)
      throw std::runtime_error("cannot write '" + path_ + "': " + std::strerror(errno));
    // Some network file systems cannot lock: there it goes without.
    is_held = ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    if (hasName(file_, path_)) break;  // else the one before removed it just then
  }
  if (is_held) {
    const std::string process = std::to_string(::getpid()) + "\n";
    if (::ftruncate(file_, 0) != 0 || ::write(file_, process.data(), process.size()) < 0) {
      // Who holds it is for people to read: the lock holds without.
    }
    return;
  }
  ::close(file_);
  std::string process;
  std::getline(std::ifstream(path_), process);
  throw std::runtime_error("the folder '" + folder + "' is in use by process " + process);
}

FolderLock::~FolderLock() {
  if (hasName(file_, path_)) ::unlink(path_.c_str());
  ::close(file_);
}

bool isLocked(const std::string& folder) {
  const int file = ::open(lockOf(folder).c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool locked = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  return locked;
}

}  // namespace revisit_slam
