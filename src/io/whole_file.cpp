// SPDX-License-Identifier: MIT
#include "revisit_slam/io/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace revisit_slam {
namespace {

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
  if (!handToDisk(temporary) || std::rename(temporary.c_str(), path.c_str()) != 0)
    throw std::runtime_error("cannot write '" + path + "'");
}

void writeWholeText(const std::string& path, const std::string& text) {
  writeWholeFile(path, [&](const std::string& temporary) {
    std::ofstream file(temporary);
    if (!(file << text << std::flush)) throw std::runtime_error("cannot write '" + path + "'");
  });
}

}  // namespace revisit_slam
