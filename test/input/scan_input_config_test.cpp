// SPDX-License-Identifier: MIT
#include "revisit_slam/input/scan_input_config.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace revisit_slam {
namespace {

/// Checks that every default is among what is allowed.
struct CheckingVisitor {
  int count = 0;

  void operator()(const char* name, const std::string& value, const Choices& choices, const char*,
                  const char*) {
    const bool allowed = std::find(choices.begin(), choices.end(), value) != choices.end();
    EXPECT_TRUE(choices.empty() || allowed) << name;
    ++count;
  }
  void operator()(const char* name, double value, const Range& range, const char*, const char*) {
    EXPECT_TRUE(range.lowest <= value && value <= range.highest) << name;
    ++count;
  }
  void operator()(const char*, bool, const char*) { ++count; }
};

TEST(ScanInputConfig, defaultsAreAllowed) {
  ScanInputConfig config;
  CheckingVisitor visitor;
  config.visit(visitor);
  EXPECT_EQ(visitor.count, 13);
}

}  // namespace
}  // namespace revisit_slam
