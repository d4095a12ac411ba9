// SPDX-License-Identifier: MIT
#include "text_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "revisit_slam/datasets/dataset_error.h"

namespace revisit_slam {
namespace {

/// Longer ones are none, and std::regex takes a piece of the stack for every letter.
constexpr std::size_t kLongestNumber = 64;

std::vector<std::string> wordsOf(const std::string& line) {
  constexpr const char* separators = " \t\r,";
  std::vector<std::string> words;
  for (std::size_t begin = 0; (begin = line.find_first_not_of(separators, begin)) != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

}  // namespace

void TextRow::fail(const std::string& what) const {
  throw DatasetError(path, "line " + std::to_string(line) + ": " + what);
}

double TextRow::number(std::size_t column) const {
  char* end = nullptr;
  const double value = std::strtod(words[column].c_str(), &end);
  if (*end != '\0' || !std::isfinite(value)) fail("'" + words[column] + "' is no number");
  return value;
}

std::int64_t TextRow::integer(std::size_t column) const {
  static const std::regex whole("-?[0-9]{1,18}|-?[1-8][0-9]{18}");
  if (words[column].size() > kLongestNumber || !std::regex_match(words[column], whole))
    fail("'" + words[column] + "' is no whole number");
  return std::stoll(words[column]);
}

Stamp TextRow::seconds(std::size_t column) const {
  static const std::regex decimal("([0-9]{1,9}|[1-8][0-9]{9})(?:\\.([0-9]*))?");
  std::smatch parts;
  if (words[column].size() > kLongestNumber) fail("'" + words[column] + "' are no seconds");
  if (std::regex_match(words[column], parts, decimal)) {
    std::string fraction = parts[2].str().substr(0, 9);
    fraction.resize(9, '0');
    return {std::stoll(parts[1]) * 1'000'000'000 + std::stoll(fraction)};
  }
  const double value = number(column);  // "1.036224e-01"
  if (value < 0.0 || value > 9e9) fail("'" + words[column] + "' are no seconds");
  return Stamp::fromSeconds(value);
}

Pose TextRow::positionAndQuaternion(std::size_t column) const {
  Pose pose;
  for (int axis = 0; axis < 3; ++axis) pose.translation[axis] = number(column + axis);
  for (int i = 0; i < 4; ++i) pose.rotation.coeffs()[i] = number(column + 3 + i);
  if (std::abs(pose.rotation.norm() - 1.0) > 0.01) fail("a quaternion is not of length one");
  pose.rotation.normalize();
  return pose;
}

Pose TextRow::matrix(std::size_t column) const {
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 12; ++i) T(i / 4, i % 4) = number(column + i);
  const Eigen::Matrix3d R = T.topLeftCorner<3, 3>();
  if (!(R * R.transpose()).isIdentity(0.01) || R.determinant() < 0.0) fail("not a rotation matrix");
  return Pose::fromMatrix(T);
}

void forEachRow(const std::string& path, std::size_t columns,
                const std::function<void(const TextRow&)>& use) {
  std::ifstream file(path);
  if (!file) throw DatasetError(path, "cannot be read");
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    const TextRow row{path, number, wordsOf(line)};
    if (row.words.empty() || row.words[0][0] == '#') continue;
    if (row.words.size() != columns)
      row.fail("has " + std::to_string(row.words.size()) + " values, not " +
               std::to_string(columns));
    use(row);
  }
  if (file.bad()) throw DatasetError(path, "cannot be read");
}

}  // namespace revisit_slam
