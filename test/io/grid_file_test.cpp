// SPDX-License-Identifier: MIT
#include "revisit_slam/io/grid_file.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(GridFile, IsWhatMapServerReads) {
  const TemporaryFolder folder;
  const std::int8_t u = ProjectedGrid::kUnknown, f = ProjectedGrid::kFree,
                    o = ProjectedGrid::kOccupied;
  writeGrid(folder.file("map"), {{-3.5, 2.0}, 0.5, 3, 2, {u, f, o, f, f, u}});
  const std::string picture = textOf(folder.file("map.pgm"));
  EXPECT_EQ(picture, std::string("P5\n3 2\n255\n") + "\xFE\xFE\xCD" + "\xCD\xFE" + '\0');
  const std::string text = textOf(folder.file("map.yaml"));
  EXPECT_NE(text.find("image: map.pgm\nresolution: 0.500000\norigin: [-3.500000, 2.000000,"),
            std::string::npos)
      << text;
}

TEST(GridFile, FailsWhereItCannotWrite) {
  EXPECT_THROW(writeGrid(TemporaryFolder().file("gone/map"), {}), std::runtime_error);
}

}  // namespace
}  // namespace revisit_slam
