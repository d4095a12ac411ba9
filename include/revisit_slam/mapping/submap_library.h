// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>

#include "revisit_slam/occupancy/submap_occupancy.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// The closed submaps of a session. Those that are on disk are in memory as long as there is room,
/// the ones that were used last; all others stay. What is read back is what was written, so that
/// nothing depends on the room. Thread-safe.
class SubmapLibrary {
 public:
  /// Reads a submap's points and normals from disk. @throws std::runtime_error
  using Read = std::function<Submap()>;

  /// `bytes`: room for submaps that are on disk.
  explicit SubmapLibrary(std::size_t bytes) : room_(bytes) {}

  void add(const SubmapPtr& submap, const SubmapOccupancyPtr& occupancy);
  /// From now on it can be read back.
  void noteStored(SubmapId id, Read read);
  /// All that another one can read, and as it reads it; none of it is in memory yet.
  void addStored(const std::shared_ptr<SubmapLibrary>& other);

  bool has(SubmapId id) const;
  /// Without points and normals. @throws std::out_of_range for one that was not added.
  SubmapPtr light(SubmapId id) const;
  /// With points and normals, read from disk where they are not in memory. @throws
  /// std::runtime_error where that fails, std::out_of_range.
  SubmapPtr whole(SubmapId id);
  /// How many it has, wherever they are. @throws std::out_of_range
  std::size_t points(SubmapId id) const;
  /// Null where it is not in memory.
  SubmapPtr inMemory(SubmapId id) const;
  SubmapOccupancyPtr occupancyInMemory(SubmapId id) const;

  /// Of points, normals and occupancy in memory.
  std::size_t bytes() const;

 private:
  struct Entry {
    SubmapPtr light;
    SubmapPtr whole;  // null: not in memory
    SubmapOccupancyPtr occupancy;
    std::size_t points = 0;
    Read read;                           // null: it is not on disk
    std::list<SubmapId>::iterator used;  // in recent_, where it is in memory and on disk
  };

  static std::size_t bytesOf(const Entry& entry);
  void use(SubmapId id, Entry& entry);
  void makeRoom();

  const std::size_t room_;
  mutable std::mutex mutex_;  // guards what follows
  std::map<SubmapId, Entry> entries_;
  std::list<SubmapId> recent_;  // could be left out; the one that was used last first
  std::size_t recent_bytes_ = 0, kept_bytes_ = 0;  // of these; of those that are not on disk
};

}  // namespace revisit_slam
