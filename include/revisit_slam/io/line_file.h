// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "revisit_slam/io/growing_file.h"

namespace revisit_slam {

/// Lines that are added to a file, which is made with the first. Those that cannot be written wait
/// for the next. Where the file is removed, it is made anew, and the lines in it are lost.
class LineFile {
 public:
  /// `header`: the first line.
  explicit LineFile(const std::string& path, const std::string& header = "")
      : path_(path), header_(header) {}

  /// Before the first line is added.
  void setHeader(const std::string& header) { header_ = header; }
  void add(const std::string& line);
  /// @throws std::runtime_error naming the file, if there are lines that cannot be written.
  void flush();
  /// Why lines wait; empty: none does.
  const std::string& problem() const { return problem_; }
  /// Whether a line was added.
  bool hasLines() const { return file_ || !waiting_.empty(); }

 private:
  std::string path_, header_;
  std::unique_ptr<GrowingFile> file_;
  std::string waiting_, problem_;
};

}  // namespace revisit_slam
