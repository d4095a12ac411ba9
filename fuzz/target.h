// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace revisit_slam::fuzz {

/// A reader of bytes that anybody may have written. What it throws as a std::exception is its
/// answer; anything else that ends it, and memory taken for what is not there, is a fault.
struct Target {
  const char* name;
  void (*read)(const std::string& bytes);
  /// Good bytes to start from, each of another kind.
  std::vector<std::string> (*seeds)();
};

const std::vector<Target>& targets();

/// Its answer is either of the two: all targets read through this.
void answer(const Target& target, const std::string& bytes);

}  // namespace revisit_slam::fuzz
