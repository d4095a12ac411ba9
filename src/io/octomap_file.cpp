// SPDX-License-Identifier: MIT
#include "revisit_slam/io/octomap_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {

void writeOctomap(const std::string& path, const OccupancyVoxels& map) {
  writeOctomap(path, *octreeOf(map));
}

void writeOctomap(const std::string& path, const octomap::OcTree& tree) {
  writeWholeFile(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    // As writeBinary() does, which prints " done." on the console where the library was built with
    // its debug output, as Debian's is.
    file << "# Octomap OcTree binary file\n"
            "# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
         << "id " << tree.getTreeType() << "\nsize " << tree.size() << "\nres "
         << tree.getResolution() << "\ndata\n";
    tree.writeBinaryData(file);
    if (!file.flush())
      throw std::runtime_error("cannot write '" + path + "': " + std::strerror(errno));
  });
}

}  // namespace revisit_slam
