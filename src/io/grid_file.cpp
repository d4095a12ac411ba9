// SPDX-License-Identifier: MIT
#include "revisit_slam/io/grid_file.h"

#include <cstdio>
#include <filesystem>

#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {
namespace {

char greyOf(std::int8_t cell) {
  if (cell == ProjectedGrid::kFree) return static_cast<char>(254);
  return cell == ProjectedGrid::kOccupied ? static_cast<char>(0) : static_cast<char>(205);
}

}  // namespace

void writeGrid(const std::string& name, const ProjectedGrid& grid) {
  std::string picture =
      "P5\n" + std::to_string(grid.width) + " " + std::to_string(grid.height) + "\n255\n";
  for (int row = grid.height - 1; row >= 0; --row)
    for (int column = 0; column < grid.width; ++column)
      picture +=
          greyOf(grid.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width) +
                            static_cast<std::size_t>(column)]);
  char text[512];
  std::snprintf(text, sizeof(text),
                "image: %s.pgm\nresolution: %.6f\norigin: [%.6f, %.6f, 0.000000]\nnegate: 0\n"
                "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
                std::filesystem::path(name).filename().c_str(), grid.resolution, grid.origin.x(),
                grid.origin.y());
  writeWholeText(name + ".pgm", picture);
  writeWholeText(name + ".yaml", text);
}

}  // namespace revisit_slam
