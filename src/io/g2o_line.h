// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// The words and numbers of one line of a g2o file, one after the other; the text must outlive it.
/// @throws std::runtime_error saying what is wrong.
class G2oLine {
 public:
  explicit G2oLine(const std::string& text) : next_(text.c_str()) {}

  std::string word() {
    skipSpace();
    const char* begin = next_;
    while (*next_ != '\0' && std::isspace(static_cast<unsigned char>(*next_)) == 0) ++next_;
    return {begin, next_};
  }

  std::uint64_t id() {
    const std::string text = word();
    const bool digits =
        !text.empty() && text.size() < 20 &&
        std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits) throw std::runtime_error("'" + text + "' is no id");
    return std::strtoull(text.c_str(), nullptr, 10);
  }

  double number() {
    char* end = nullptr;
    const double value = std::strtod(next_, &end);
    if (end == next_) throw std::runtime_error("a number is missing");
    if (!std::isfinite(value)) throw std::runtime_error("a number is not finite");
    if (std::abs(value) > kLargest) throw std::runtime_error("a number is larger than 1e30");
    next_ = end;
    return value;
  }

  Pose pose() {
    Pose T;
    for (int i = 0; i < 3; ++i) T.translation[i] = number();
    for (int i = 0; i < 4; ++i) T.rotation.coeffs()[i] = number();
    if (!(T.rotation.norm() > 1e-3)) throw std::runtime_error("the quaternion has no length");
    T.rotation.normalize();
    return T;
  }

  /// A symmetric matrix, given by its upper triangle.
  Matrix6 symmetric() {
    Matrix6 A;
    for (int row = 0; row < 6; ++row)
      for (int col = row; col < 6; ++col) A(row, col) = A(col, row) = number();
    return A;
  }

  bool isAtEnd() {
    skipSpace();
    return *next_ == '\0';
  }

  void requireEnd() {
    if (!isAtEnd()) throw std::runtime_error("too much at '" + std::string(next_) + "'");
  }

 private:
  static constexpr double kLargest = 1e30;  // squares of squares are finite

  void skipSpace() {
    while (std::isspace(static_cast<unsigned char>(*next_)) != 0) ++next_;
  }

  const char* next_;
};

}  // namespace revisit_slam
