// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace revisit_slam {

/// A file that grows by whole pieces: one that could not be written whole leaves no trace.
class GrowingFile {
 public:
  /// Makes the file, which must not exist. @throws std::runtime_error naming it and the reason.
  explicit GrowingFile(const std::string& path);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// @throws std::runtime_error naming the file and the reason (disk full, file removed, …). The
  /// same piece may be appended again later.
  void append(const std::string& bytes);
  /// Hands to the disk what was appended. @throws likewise; what was appended since the last time
  /// does not count then, and may be appended again.
  void sync();

  /// Whether the file has been removed: what was in it is gone.
  bool removed() const;
  /// Bytes that were appended.
  std::uint64_t size() const { return size_; }
  const std::string& path() const { return path_; }

 private:
  [[noreturn]] void fail() const;
  void cutBack();

  std::string path_;
  int file_;
  std::uint64_t size_ = 0, synced_ = 0;
  bool torn_ = false;  // there may be bytes behind size_
};

}  // namespace revisit_slam
