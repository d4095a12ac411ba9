// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace revisit_slam {

/// Keeps a folder for one writer, in this process or any other, as long as the object lives. The
/// system lets go of it when the process ends, however it ends.
class FolderLock {
 public:
  /// @throws std::runtime_error naming the folder: in use, with the process that uses it, or why
  /// its file `lock` cannot be made.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::string path_;
  int file_ = -1;
};

/// Whether somebody holds the folder.
bool isLocked(const std::string& folder);

}  // namespace revisit_slam
