// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "revisit_slam/io/stored_pose.h"
#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"
#include "revisit_slam/types/stamp.h"

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "files are little-endian");

namespace revisit_slam {

/// Numbers and poses one after the other, little-endian and without gaps.
class ByteWriter {
 public:
  template <typename Number>
  void put(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    append(&value, sizeof(value));
  }
  void put(Stamp stamp) { put(stamp.nanoseconds); }
  /// Quaternion x y z w, then translation x y z.
  void put(const Pose& T) {
    append(T.rotation.coeffs().data(), 4 * sizeof(double));
    append(T.translation.data(), 3 * sizeof(double));
  }
  /// Row by row.
  void put(const Matrix6& matrix) {
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column) put(matrix(row, column));
  }
  /// Session, then number.
  template <typename Tag>
  void put(Id<Tag> id) {
    put(id.session.value);
    put(id.value);
  }
  /// The elements as they lie in memory.
  template <typename Element>
  void putAll(const std::vector<Element>& elements) {
    append(elements.data(), elements.size() * sizeof(Element));
  }

  const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }

  std::string bytes_;
};

/// Takes out what a ByteWriter has put in. It throws std::runtime_error beyond the end, and where
/// a pose or a matrix is none.
class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(bytes) {}

  template <typename Number>
  Number get() {
    static_assert(std::is_arithmetic_v<Number>);
    Number value;
    take(&value, sizeof(value));
    return value;
  }
  Stamp stamp() {
    const Stamp stamp{get<std::int64_t>()};
    if (stamp < Stamp{-kLatest} || stamp > Stamp{kLatest})
      throw std::runtime_error("a record has a stamp that is none");
    return stamp;
  }
  Pose pose() {
    Pose T;
    take(T.rotation.coeffs().data(), 4 * sizeof(double));
    take(T.translation.data(), 3 * sizeof(double));
    if (!isPose(T)) throw std::runtime_error("a record has a pose that is none");
    return T;
  }
  Matrix6 matrix() {
    Matrix6 matrix;
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column) matrix(row, column) = get<double>();
    if (!(matrix.array().abs() < kLargest).all())
      throw std::runtime_error("a record has a matrix that is none");
    return matrix;
  }
  template <typename AnyId>
  AnyId id() {
    const SessionId session{get<std::uint32_t>()};
    return {get<std::uint32_t>(), session};
  }
  template <typename Element>
  std::vector<Element> all(std::size_t count) {
    if (count > left() / sizeof(Element)) throw std::runtime_error("a record ends too early");
    std::vector<Element> elements(count);
    if (count > 0) take(reinterpret_cast<char*>(elements.data()), count * sizeof(Element));
    return elements;
  }
  /// Everything that is left.
  template <typename Element>
  std::vector<Element> rest() {
    return all<Element>(left() / sizeof(Element));
  }
  std::size_t left() const { return bytes_.size() - position_; }

 private:
  static constexpr double kLargest = 1e30;  // of entries: squares of squares are finite
  static constexpr std::int64_t kLatest = 4'300'000'000'000'000'000;  // ns: all that ROS can say

  void take(void* data, std::size_t size) {
    if (size > left()) throw std::runtime_error("a record ends too early");
    std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
  }

  const std::string& bytes_;
  std::size_t position_ = 0;
};

}  // namespace revisit_slam
