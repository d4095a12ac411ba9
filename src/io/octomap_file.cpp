// SPDX-License-Identifier: MIT
#include "revisit_slam/io/octomap_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "revisit_slam/io/whole_file.h"

namespace revisit_slam {
namespace {

constexpr int kLevels = 16;
constexpr int kBlockLevel = 3;
constexpr int kHalf = 1 << (kLevels - kBlockLevel - 1);  // blocks from the origin to the border

/// As the file has it, two bits for each child.
enum NodeState : unsigned { kUnknown = 0, kFree = 1, kOccupied = 2, kInner = 3 };

/// Bits of x, y and z in turn, x lowest: children of a node follow each other.
std::uint64_t treeOrder(const Voxel& block) {
  std::uint64_t order = 0;
  for (int level = 0; level < kLevels - kBlockLevel; ++level)
    for (int axis = 0; axis < 3; ++axis)
      order |= static_cast<std::uint64_t>((block[axis] + kHalf) >> level & 1) << (3 * level + axis);
  return order;
}

/// A block and where it stands in the tree.
using Leaf = std::pair<std::uint64_t, const OccupancyBlock*>;
using Leaves = std::vector<Leaf>;

/// Writes nodes before their children, and takes them back when all children are equal.
class Encoder {
 public:
  /// The node that holds the blocks [begin, end).
  NodeState encode(Leaves::const_iterator begin, Leaves::const_iterator end, int level) {
    if (begin == end) return kUnknown;
    if (level == kBlockLevel) return encodeBlock(*begin->second, Voxel::Zero(), level);
    auto child_begin = begin;
    return encodeChildren([&](unsigned child) {
      const int shift = 3 * (level - 1 - kBlockLevel);
      const auto child_end = std::find_if(
          child_begin, end, [&](const Leaf& leaf) { return (leaf.first >> shift & 7) != child; });
      return encode(std::exchange(child_begin, child_end), child_end, level - 1);
    });
  }

  const std::string& bytes() const { return bytes_; }
  std::size_t nodes() const { return nodes_; }

 private:
  NodeState encodeBlock(const OccupancyBlock& block, const Voxel& corner, int level) {
    if (level == 0) {
      const int bit = bitOf(corner);
      return block.occupied.test(bit) ? kOccupied : block.free.test(bit) ? kFree : kUnknown;
    }
    const int half = 1 << (level - 1);
    return encodeChildren([&](unsigned child) {
      const Voxel offset(child & 1, child >> 1 & 1, child >> 2 & 1);
      return encodeBlock(block, corner + half * offset, level - 1);
    });
  }

  template <typename EncodeChild>
  NodeState encodeChildren(EncodeChild encode_child) {
    const std::size_t place = bytes_.size(), nodes_before = nodes_;
    bytes_.append(2, '\0');
    std::array<NodeState, 8> children;
    unsigned code = 0;
    for (unsigned child = 0; child < 8; ++child) {
      children[child] = encode_child(child);
      code |= children[child] << (2 * child);
      nodes_ += children[child] != kUnknown;
    }
    const NodeState first = children[0];
    if (first != kInner && std::all_of(children.begin(), children.end(),
                                       [&](NodeState child) { return child == first; })) {
      bytes_.resize(place);
      nodes_ = nodes_before;
      return first;
    }
    bytes_[place] = static_cast<char>(code & 0xff);
    bytes_[place + 1] = static_cast<char>(code >> 8);
    return kInner;
  }

  std::string bytes_;
  std::size_t nodes_ = 0;
};

Leaves leavesOf(const OccupancyMap& map) {
  Leaves leaves;
  for (const OccupancyBlock& block : map.blocks()) {
    if (block.block.minCoeff() < -kHalf || block.block.maxCoeff() >= kHalf)
      throw std::runtime_error("the map is larger than an octree of 16 levels");
    leaves.emplace_back(treeOrder(block.block), &block);
  }
  std::sort(leaves.begin(), leaves.end());
  return leaves;
}

}  // namespace

void writeOctomap(const std::string& path, const OccupancyMap& map) {
  const Leaves leaves = leavesOf(map);
  Encoder tree;
  const bool root = tree.encode(leaves.begin(), leaves.end(), kLevels) == kInner;
  writeWholeFile(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << "# Octomap OcTree binary file\n"
            "# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
         << "id OcTree\nsize " << tree.nodes() + (root ? 1 : 0) << "\nres " << map.resolution()
         << "\ndata\n"
         << tree.bytes() << std::flush;
    if (!file) throw std::runtime_error("cannot write '" + path + "'");
  });
}

}  // namespace revisit_slam
