// SPDX-License-Identifier: MIT
// One target for libFuzzer (scripts/fuzz). REVISIT_SLAM_FUZZ_SEEDS=FOLDER: writes its seeds there,
// and ends.
#include <cstdint>
#include <cstdlib>
#include <fstream>

#include "target.h"

namespace {

const revisit_slam::fuzz::Target& target() {
  for (const auto& target : revisit_slam::fuzz::targets())
    if (std::string(target.name) == REVISIT_SLAM_FUZZ_TARGET) return target;
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* folder = std::getenv("REVISIT_SLAM_FUZZ_SEEDS");
  if (!folder) return 0;
  int number = 0;
  for (const std::string& seed : target().seeds())
    std::ofstream(std::string(folder) + "/seed_" + std::to_string(number++), std::ios::binary)
        << seed;
  std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const revisit_slam::fuzz::Target& one = target();
  revisit_slam::fuzz::answer(one, std::string(data, data + size));
  return 0;
}
