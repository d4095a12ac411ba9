// SPDX-License-Identifier: MIT
#include "revisit_slam/io/growing_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "revisit_slam/io/file_name.h"

namespace revisit_slam {

GrowingFile::GrowingFile(const std::string& path)
    : path_(path), file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
  if (file_ < 0) fail();
}

GrowingFile::~GrowingFile() {
  ::close(file_);
}

void GrowingFile::fail() const {
  throw std::runtime_error("cannot write '" + path_ + "': " + std::strerror(errno));
}

void GrowingFile::cutBack() {
  if (::ftruncate(file_, static_cast<off_t>(size_)) != 0) fail();
  torn_ = false;
}

void GrowingFile::append(const std::string& bytes) {
  if (removed()) {
    errno = ENOENT;
    fail();
  }
  if (torn_) cutBack();
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written =
        ::pwrite(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(size_ + done));
    if (written > 0) {
      done += static_cast<std::size_t>(written);
    } else if (errno != EINTR) {
      torn_ = done > 0;
      const int reason = errno;
      if (torn_ && ::ftruncate(file_, static_cast<off_t>(size_)) == 0) torn_ = false;
      errno = reason;
      fail();
    }
  }
  size_ += bytes.size();
}

/// What may not have reached the disk is cut off by the next append, which follows it anew.
void GrowingFile::sync() {
  if (::fdatasync(file_) == 0) {
    synced_ = size_;
    return;
  }
  size_ = synced_;
  torn_ = true;
  fail();
}

bool GrowingFile::removed() const {
  return !hasName(file_, path_);
}

}  // namespace revisit_slam
