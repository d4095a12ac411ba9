// SPDX-License-Identifier: MIT
#include "files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace revisit_slam {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_scan = std::uintmax_t{1} << 30;  // bytes

}  // namespace

std::optional<std::string> findBelow(const std::string& folder,
                                     const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    std::error_code ignored;
    const fs::path path = fs::path(folder) / name;
    if (fs::exists(path, ignored)) return path.string();
  }
  return std::nullopt;
}

std::string requireBelow(const std::string& folder, const std::vector<std::string>& names) {
  if (const auto path = findBelow(folder, names)) return *path;
  std::string wanted;
  for (const std::string& name : names) wanted += (wanted.empty() ? "" : " or ") + name;
  throw DatasetError(folder, "has no " + wanted);
}

std::optional<std::int64_t> wholeNumber(const std::string& stem) {
  constexpr std::size_t most_digits = 18;  // and one more that fits, as 10^18 < 2^63
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  if (stem.empty() || !std::all_of(stem.begin(), stem.end(), is_digit)) return std::nullopt;
  if (stem.size() > most_digits + 1 || (stem.size() == most_digits + 1 && stem[0] > '8'))
    return std::nullopt;
  return std::stoll(stem);
}

std::vector<NumberedFile> numberedFiles(const std::string& folder, const std::string& extension,
                                        const NumberInName& number) {
  std::vector<NumberedFile> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path.extension() != extension) continue;
    if (const auto found = number(path.stem().string())) files.push_back({*found, path.string()});
  }
  if (error) throw DatasetError(folder, "cannot be listed: " + error.message());
  if (files.empty()) throw DatasetError(folder, "holds no scans (*" + extension + ")");
  std::sort(files.begin(), files.end(), [](const NumberedFile& a, const NumberedFile& b) {
    return a.number != b.number ? a.number < b.number : a.path < b.path;
  });
  return files;
}

std::vector<ScanFile> scansByStamp(const std::vector<NumberedFile>& files) {
  std::vector<ScanFile> scans;
  for (const NumberedFile& file : files) scans.push_back({file.path, {file.number}});
  return scans;
}

std::vector<std::uint8_t> readBytes(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw DatasetError(path, "cannot be read: " + error.message());
  if (size == 0) throw DatasetError(path, "is empty");
  if (size > largest_scan)
    throw DatasetError(path, "has " + std::to_string(size) + " bytes, too many for a scan");
  std::vector<std::uint8_t> bytes(size);
  std::ifstream file(path, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    throw DatasetError(path, "cannot be read");
  return bytes;
}

}  // namespace revisit_slam
