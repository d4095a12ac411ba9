// SPDX-License-Identifier: MIT
#include "revisit_slam/io/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace revisit_slam {
namespace {

/// Of a file, or of the names in a folder.
bool handToDisk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY);
  if (file < 0) return false;
  const bool synced = ::fsync(file) == 0;
  ::close(file);
  return synced;
}

}  // namespace

void writeWholeFile(const std::string& path,
                    const std::function<void(const std::string& temporary)>& write) {
  const std::string temporary = path + ".part";
  try {
    write(temporary);
  } catch (...) {
    std::remove(temporary.c_str());
    throw;
  }
  replaceWholeFile(temporary, path);
}

void replaceWholeFile(const std::string& temporary, const std::string& path) {
  if (!handToDisk(temporary) || std::rename(temporary.c_str(), path.c_str()) != 0) {
    const int reason = errno;
    std::remove(temporary.c_str());
    throw std::runtime_error("cannot write '" + path + "': " + std::strerror(reason));
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  handToDisk(folder.empty() ? "." : folder);
}

void writeWholeText(const std::string& path, const std::string& text) {
  writeWholeFile(path, [&](const std::string& temporary) {
    std::ofstream file(temporary);
    if (!(file << text << std::flush))
      throw std::runtime_error("cannot write '" + path + "': " + std::strerror(errno));
  });
}

}  // namespace revisit_slam
