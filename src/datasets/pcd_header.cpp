// SPDX-License-Identifier: MIT
#include "pcd_header.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "revisit_slam/datasets/dataset_error.h"

namespace revisit_slam {
namespace {

constexpr std::size_t longest_line = 4096, most_lines = 64, most_fields = 64, most_counts = 4096;
constexpr std::size_t most_points = std::size_t{1} << 26, most_bytes = std::size_t{1} << 30;

using Entries = std::map<std::string, std::vector<std::string>>;

std::size_t wholeNumber(const std::string& path, const std::string& entry, const std::string& text,
                        std::size_t largest) {
  const bool digits = !text.empty() && text.size() <= 10 &&
                      text.find_first_not_of("0123456789") == std::string::npos;
  if (!digits || std::stoull(text) > largest)
    throw DatasetError(path, "PCD header: " + entry + " is '" + text + "'");
  return std::stoull(text);
}

NumberType numberType(const std::string& type, std::size_t size) {
  const std::string key = type + std::to_string(size);
  if (key == "I1") return NumberType::int8;
  if (key == "U1") return NumberType::uint8;
  if (key == "I2") return NumberType::int16;
  if (key == "U2") return NumberType::uint16;
  if (key == "I4") return NumberType::int32;
  if (key == "U4") return NumberType::uint32;
  if (key == "F4") return NumberType::float32;
  if (key == "F8") return NumberType::float64;
  return NumberType::unknown;
}

/// Splits the lines up to DATA into their first word and the others.
Entries readEntries(const std::string& path, const std::vector<std::uint8_t>& bytes,
                    std::size_t& size) {
  Entries entries;
  auto line_begin = bytes.begin();
  for (std::size_t count = 0; count < most_lines && entries.count("DATA") == 0; ++count) {
    const auto left = bytes.end() - line_begin;
    const auto limit = line_begin + std::min<std::ptrdiff_t>(longest_line, left);
    const auto line_end = std::find(line_begin, limit, '\n');
    if (line_end == limit) break;
    std::istringstream words(std::string(line_begin, line_end));
    std::string key, word;
    words >> key;
    if (!key.empty() && key[0] != '#')
      for (entries[key].clear(); words >> word;) entries[key].push_back(word);
    line_begin = line_end + 1;
  }
  if (entries.count("DATA") == 0) throw DatasetError(path, "has no PCD header");
  size = static_cast<std::size_t>(line_begin - bytes.begin());
  return entries;
}

/// The words of an entry, `count` of them.
const std::vector<std::string>& wordsOf(const std::string& path, Entries& entries,
                                        const std::string& key, std::size_t count) {
  if (entries[key].size() != count)
    throw DatasetError(path, "PCD header: " + key + " has " + std::to_string(entries[key].size()) +
                                 " values, not " + std::to_string(count));
  return entries[key];
}

void readFields(const std::string& path, Entries& entries, PcdHeader& header) {
  const std::vector<std::string>& names = entries["FIELDS"];
  if (names.empty() || names.size() > most_fields)
    throw DatasetError(path, "PCD header: " + std::to_string(names.size()) + " FIELDS");
  if (entries.count("COUNT") == 0) entries["COUNT"].assign(names.size(), "1");
  const auto& sizes = wordsOf(path, entries, "SIZE", names.size());
  const auto& types = wordsOf(path, entries, "TYPE", names.size());
  const auto& counts = wordsOf(path, entries, "COUNT", names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    PcdField field;
    field.name = names[i];
    field.size = static_cast<std::uint32_t>(wholeNumber(path, "SIZE", sizes[i], 8));
    field.count = static_cast<std::uint32_t>(wholeNumber(path, "COUNT", counts[i], most_counts));
    field.type = numberType(types[i], field.size);
    const bool long_integer = field.size == 8 && (types[i] == "I" || types[i] == "U");
    if (field.type == NumberType::unknown && !long_integer)
      throw DatasetError(path, "PCD header: TYPE " + types[i] + " of SIZE " + sizes[i]);
    field.offset = header.point_step;
    header.point_step += field.bytes();
    header.fields.push_back(field);
  }
  if (header.point_step == 0) throw DatasetError(path, "PCD header: points without bytes");
}

PcdEncoding encodingOf(const std::string& path, const std::string& word) {
  if (word == "ascii") return PcdEncoding::ascii;
  if (word == "binary") return PcdEncoding::binary;
  if (word == "binary_compressed") return PcdEncoding::binary_compressed;
  throw DatasetError(path, "PCD header: DATA is '" + word + "'");
}

}  // namespace

PcdHeader parsePcdHeader(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  PcdHeader header;
  Entries entries = readEntries(path, bytes, header.size);
  readFields(path, entries, header);
  const auto extent = [&](const std::string& key) {
    const std::string& word = wordsOf(path, entries, key, 1)[0];
    return wholeNumber(path, key, word, most_points);
  };
  header.width = static_cast<std::uint32_t>(extent("WIDTH"));
  header.height = static_cast<std::uint32_t>(extent("HEIGHT"));
  if (entries.count("POINTS") > 0 && extent("POINTS") != header.points())
    throw DatasetError(path, "PCD header: POINTS is not WIDTH times HEIGHT");
  if (header.points() == 0) throw DatasetError(path, "has no points");
  if (header.points() > most_bytes / header.point_step)
    throw DatasetError(path, "has too many points for a scan");
  header.encoding = encodingOf(path, wordsOf(path, entries, "DATA", 1)[0]);
  return header;
}

}  // namespace revisit_slam
