// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace revisit_slam {

/// Numbers one after the other, as a recorder writes them.
class ByteFile {
 public:
  template <typename T>
  ByteFile& put(T value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
    return *this;
  }
  template <typename Vector>
  ByteFile& putPoint(const Vector& p) {
    return put<float>(p.x()).template put<float>(p.y()).template put<float>(p.z());
  }
  ByteFile& text(const std::string& text) {
    bytes_ += text;
    return *this;
  }

  std::size_t size() const { return bytes_.size(); }

  /// Makes the folders that it needs.
  void save(const std::string& path) const {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path, std::ios::binary) << bytes_;
  }

 private:
  std::string bytes_;
};

}  // namespace revisit_slam
