// SPDX-License-Identifier: MIT
#include "revisit_slam/io/line_file.h"

#include <stdexcept>

namespace revisit_slam {

void LineFile::add(const std::string& line) {
  waiting_ += line;
  try {
    flush();
  } catch (const std::runtime_error& error) {
    problem_ = error.what();
  }
}

void LineFile::flush() {
  if (file_ && file_->removed()) file_.reset();
  if (!file_) file_ = std::make_unique<GrowingFile>(path_);
  file_->append(file_->size() == 0 ? header_ + waiting_ : waiting_);
  waiting_.clear();
  problem_.clear();
}

}  // namespace revisit_slam
