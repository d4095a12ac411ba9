// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/session_targets.h"

#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace revisit_slam {
namespace {

/// `path`, with a number behind it if there is something of that name.
std::string freeName(const std::string& path) {
  std::string free = path;
  std::error_code ignored;
  for (int i = 2;
       std::filesystem::exists(free, ignored) && !std::filesystem::is_empty(free, ignored); ++i)
    free = path + "_" + std::to_string(i);
  return free;
}

/// FOLDER/2024-05-17_09-30-00 (UTC).
std::string nameOf(const std::string& folder, Stamp start) {
  const std::time_t seconds = start.nanoseconds / 1'000'000'000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char name[32];
  std::strftime(name, sizeof(name), "%Y-%m-%d_%H-%M-%S", &utc);
  return folder + "/" + name;
}

}  // namespace

SessionTargets liveTargets(const LiveConfig& live, const std::string& sensor) {
  return [folder = live.folder, sensor](SessionId, Stamp start) {
    SessionTarget target;
    if (!folder.empty()) target.folder = freeName(nameOf(folder, start));
    target.is_ours = true;  // the log of the drive may be in it before the session is
    target.sensor = sensor;
    return target;
  };
}

void requireWritable(const LiveConfig& live) {
  if (live.folder.empty()) return;
  for (const std::filesystem::path& part : std::filesystem::path(live.folder))
    if (part == "~")
      throw ParameterError("live/folder is '" + live.folder +
                           "': ~ is not expanded here, so write the folder out");
  std::error_code error;
  std::filesystem::create_directories(live.folder, error);
  const std::string trial = live.folder + "/.trial_" + std::to_string(getpid());
  if (!error && !std::ofstream(trial)) error.assign(errno, std::generic_category());
  std::error_code ignored;
  std::filesystem::remove(trial, ignored);
  if (error)
    throw ParameterError("live/folder is '" + live.folder + "', where nothing can be written (" +
                         error.message() + "): choose another, for example folder:=" +
                         std::filesystem::temp_directory_path().string() + "/maps");
}

std::string folderToSaveIn(const std::string& folder, const LiveConfig& live) {
  const std::filesystem::path path = std::filesystem::path(folder).lexically_normal();
  if (!path.is_relative()) return freeName(path.string());
  if (*path.begin() == ".." || path == ".")
    throw std::runtime_error("'" + folder + "' is not a folder within live/folder");
  if (live.folder.empty())
    throw std::runtime_error("'" + folder +
                             "' is relative: give an absolute folder, or set live/folder, in which "
                             "relative ones are");
  return freeName(live.folder + "/" + path.string());
}

}  // namespace revisit_slam
