// SPDX-License-Identifier: MIT
#include "revisit_slam/util/number_list.h"

#include <gtest/gtest.h>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {
namespace {

TEST(NumberList, NumbersStandBetweenSpaces) {
  EXPECT_EQ(numbersOf(" 1.5 -2  3e2 ", "p", "numbers"), (std::vector<double>{1.5, -2.0, 300.0}));
  EXPECT_TRUE(numbersOf("  ", 3, "p", "numbers").empty());
  EXPECT_EQ(wordsOf("/a  /b"), (std::vector<std::string>{"/a", "/b"}));
}

TEST(NumberList, WhatIsNoneIsNamedWithItsParameter) {
  for (const char* text : {"1 x 3", "1 nan 3", "1 2", "1 2 3 4", "1,2,3"}) {
    try {
      numbersOf(text, 3, "group/name", "three numbers");
      FAIL() << text;
    } catch (const ParameterError& error) {
      EXPECT_EQ(std::string(error.what()),
                std::string("parameter 'group/name' is '") + text + "', not three numbers");
    }
  }
}

}  // namespace
}  // namespace revisit_slam
