// SPDX-License-Identifier: MIT
#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <cstdint>
#include <vector>

#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {

/// A number for each of some voxels. The numbers of a cube of voxels are kept together, as who asks
/// for one asks for its neighbours next: then a table of the cubes, which is small, is searched
/// seldom, and one line of the processor's cache holds many of the answers. Where memory is short
/// (std::bad_alloc) everything is as it was before.
class VoxelNumbers {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Reads one voxel after another; as long as the numbers do not change. One for each thread.
  class Reader {
   public:
    explicit Reader(const VoxelNumbers& numbers) : numbers_(numbers) {}

    /// kNone where there is none.
    std::uint32_t at(const Voxel& voxel) {
      const std::uint64_t key = keyOf(voxel);
      if (key != key_) {
        key_ = key;
        const auto entry = numbers_.cube_of_.find(key);
        numbers_of_cube_ = entry == numbers_.cube_of_.end()
                               ? nullptr
                               : numbers_.cubes_[entry->second].numbers.data();
      }
      return numbers_of_cube_ ? numbers_of_cube_[placeOf(voxel)] : kNone;
    }

   private:
    const VoxelNumbers& numbers_;
    std::uint64_t key_ = kNoKey;
    const std::uint32_t* numbers_of_cube_ = nullptr;
  };

  /// How many voxels have one.
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /// The number of the voxel, which is `next` from now on if it had none.
  std::uint32_t tryEmplace(const Voxel& voxel, std::uint32_t next) {
    Cube& cube = cubeAt(voxel);
    std::uint32_t& number = cube.numbers[placeOf(voxel)];
    if (number != kNone) return number;
    ++cube.used;
    ++size_;
    return number = next;
  }

  /// Of a voxel that has a number.
  void erase(const Voxel& voxel);

  /// Calls visit(voxel, number) for each, ordered by voxel: x, then y, then z.
  template <typename Visit>
  void forEach(Visit visit) const;

 private:
  static constexpr int kEdge = 4;
  static constexpr int kVoxels = kEdge * kEdge * kEdge;
  static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};  // no packed voxel

  struct Cube {
    std::array<std::uint32_t, kVoxels> numbers;
    Voxel place;
    int used;
  };

  static std::uint64_t keyOf(const Voxel& voxel) {
    return packVoxel(Voxel(voxel.x() >> 2, voxel.y() >> 2, voxel.z() >> 2));
  }
  static std::size_t placeOf(const Voxel& voxel) {
    return static_cast<std::size_t>((voxel.x() & 3) << 4 | (voxel.y() & 3) << 2 | (voxel.z() & 3));
  }

  Cube& cubeAt(const Voxel& voxel) {
    const std::uint64_t key = keyOf(voxel);
    if (key != last_key_) {
      last_ = findOrAdd(key, voxel);
      last_key_ = key;
    }
    return cubes_[last_];
  }
  std::uint32_t findOrAdd(std::uint64_t key, const Voxel& voxel);
  /// Those that are used, ordered by place.
  std::vector<const Cube*> cubesInOrder() const;

  tsl::robin_map<std::uint64_t, std::uint32_t, VoxelKeyHash> cube_of_;
  std::vector<Cube> cubes_;
  std::vector<std::uint32_t> free_;
  std::size_t size_ = 0;
  std::uint64_t last_key_ = kNoKey;
  std::uint32_t last_ = 0;
};

/// Slice by slice of a layer of cubes, of each the rows of a column of cubes one after another.
template <typename Visit>
void VoxelNumbers::forEach(Visit visit) const {
  const std::vector<const Cube*> cubes = cubesInOrder();
  const auto endOf = [&](std::size_t begin, int axes) {
    std::size_t end = begin;
    while (end < cubes.size() && cubes[end]->place.head(axes) == cubes[begin]->place.head(axes))
      ++end;
    return end;
  };
  for (std::size_t layer = 0, end = 0; layer < cubes.size(); layer = end) {
    end = endOf(layer, 1);
    for (int x = 0; x < kEdge; ++x)
      for (std::size_t column = layer, next = 0; column < end; column = next) {
        next = endOf(column, 2);
        for (int y = 0; y < kEdge; ++y)
          for (std::size_t i = column; i < next; ++i)
            for (int z = 0; z < kEdge; ++z) {
              const Voxel voxel = kEdge * cubes[i]->place + Voxel(x, y, z);
              const std::uint32_t number = cubes[i]->numbers[placeOf(voxel)];
              if (number != kNone) visit(voxel, number);
            }
      }
  }
}

}  // namespace revisit_slam
