// SPDX-License-Identifier: MIT
#pragma once

#include <pcl/io/lzf.h>

#include <string>

#include "datasets/byte_file.h"

namespace revisit_slam {

inline std::string pcdHeader(const std::string& fields, const std::string& sizes,
                             const std::string& types, std::size_t points,
                             const std::string& encoding) {
  const std::string count = std::to_string(points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " +
         sizes + "\nTYPE " + types + "\nWIDTH " + count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n" +
         "POINTS " + count + "\nDATA " + encoding + "\n";
}

/// Compressed PCD of points that lie field by field in `body`.
inline ByteFile compressedPcd(const std::string& fields, const std::string& sizes,
                              const std::string& types, std::size_t points,
                              const std::string& body) {
  std::string packed(body.size() * 2, '\0');
  packed.resize(pcl::lzfCompress(body.data(), static_cast<unsigned>(body.size()), &packed[0],
                                 static_cast<unsigned>(packed.size())));
  ByteFile file;
  file.text(pcdHeader(fields, sizes, types, points, "binary_compressed"));
  file.put(static_cast<std::uint32_t>(packed.size()));
  return file.put(static_cast<std::uint32_t>(body.size())).text(packed);
}

}  // namespace revisit_slam
