// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/save_root.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace revisit_slam {
namespace {

namespace fs = std::filesystem;

/// Links in what is there are followed; what is not there has none.
fs::path real(const fs::path& path) {
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path));
  return canonical.has_filename() ? canonical : canonical.parent_path();
}

bool isBelow(const fs::path& root, const fs::path& path) {
  const auto [root_end, rest] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
  return root_end == root.end() && rest != path.end();
}

}  // namespace

void requireBelowSaveRoot(const LiveConfig& live, const std::string& folder) {
  if (live.save_root.empty() || folder.empty()) return;
  const fs::path path = fs::path(live.folder) / folder;  // an absolute one stays what it is
  if (!isBelow(real(live.save_root), real(path)))
    throw std::runtime_error("'" + folder + "' is not below live/save_root, '" + live.save_root +
                             "'");
}

}  // namespace revisit_slam
