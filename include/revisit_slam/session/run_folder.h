// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "revisit_slam/io/folder_lock.h"
#include "revisit_slam/session/drive_log.h"
#include "revisit_slam/session/run_summary.h"

namespace revisit_slam {

/// The folder that a run of `offline` leaves behind.
class RunFolder {
 public:
  /// Makes the folder with its parents, and locks it. @throws std::runtime_error naming a path that
  /// cannot be made, is in use, or holds results already.
  explicit RunFolder(const std::string& path);

  const std::string& path() const { return path_; }
  const std::shared_ptr<FolderLock>& lock() const { return lock_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  DriveLog& log() { return log_; }
  const DriveLog& log() const { return log_; }

  /// Writes run.json, whole or not at all, and lines that wait. @throws std::runtime_error
  void finish(RunSummary summary);

 private:
  std::string path_;
  std::shared_ptr<FolderLock> lock_;
  DriveLog log_;
};

}  // namespace revisit_slam
