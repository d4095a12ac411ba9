// SPDX-License-Identifier: MIT
#include "revisit_slam/io/file_name.h"

#include <sys/stat.h>

namespace revisit_slam {

bool hasName(int file, const std::string& path) {
  struct stat ours = {};
  struct stat named = {};
  return ::fstat(file, &ours) == 0 && ::stat(path.c_str(), &named) == 0 &&
         ours.st_ino == named.st_ino && ours.st_dev == named.st_dev;
}

}  // namespace revisit_slam
