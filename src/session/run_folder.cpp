// SPDX-License-Identifier: MIT
#include "revisit_slam/session/run_folder.h"

#include <filesystem>
#include <stdexcept>

#include "revisit_slam/session/session_writer.h"

namespace revisit_slam {
namespace {

/// Makes the folder before the files in it are opened.
std::string made(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error("cannot make the folder '" + path + "': " + error.message());
  requireUnused(path);
  return path;
}

}  // namespace

RunFolder::RunFolder(const std::string& path)
    : path_(made(path)), lock_(std::make_shared<FolderLock>(path)), log_(path) {}

void RunFolder::finish(RunSummary summary) {
  log_.tell(summary);
  writeRunSummary(file("run.json"), summary);
  log_.flush();
}

}  // namespace revisit_slam
