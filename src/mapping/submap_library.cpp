// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/submap_library.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace revisit_slam {
namespace {

SubmapPtr withoutPoints(const Submap& submap) {
  auto light = std::make_shared<Submap>();
  light->id = submap.id;
  light->local_map = submap.local_map;
  light->first_scan = submap.first_scan;
  light->travelled_begin = submap.travelled_begin;
  light->travelled_end = submap.travelled_end;
  light->unsure_begin = submap.unsure_begin;
  light->scale = submap.scale;
  light->T_odom_submap = submap.T_odom_submap;
  light->T_submap_scan = submap.T_submap_scan;
  light->stamps = submap.stamps;
  return light;
}

}  // namespace

std::size_t SubmapLibrary::bytesOf(const Entry& entry) {
  const std::size_t points = entry.whole->points.size() + entry.whole->normals.size();
  return points * sizeof(Eigen::Vector3f) + (entry.occupancy ? entry.occupancy->bytes() : 0);
}

void SubmapLibrary::add(const SubmapPtr& submap, const SubmapOccupancyPtr& occupancy) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Entry& entry = entries_[submap->id];
  entry.light = withoutPoints(*submap);
  entry.whole = submap;
  entry.occupancy = occupancy;
  entry.points = submap->points.size();
  kept_bytes_ += bytesOf(entry);
}

void SubmapLibrary::noteStored(SubmapId id, Read read) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Entry& entry = entries_.at(id);
  const bool is_new = !std::exchange(entry.read, std::move(read));
  if (!is_new) return;
  kept_bytes_ -= bytesOf(entry);
  use(id, entry);
}

void SubmapLibrary::addStored(const std::shared_ptr<SubmapLibrary>& other) {
  const std::scoped_lock lock(mutex_, other->mutex_);
  for (const auto& [id, entry] : other->entries_) {
    if (!entry.read) continue;
    Entry& stored = entries_[id];
    stored.light = entry.light;
    stored.points = entry.points;
    stored.read = [other, id = id] { return *other->whole(id); };
  }
}

/// Puts it first among those that could be left out.
void SubmapLibrary::use(SubmapId id, Entry& entry) {
  entry.used = recent_.insert(recent_.begin(), id);
  recent_bytes_ += bytesOf(entry);
  makeRoom();
}

void SubmapLibrary::makeRoom() {
  while (recent_bytes_ > room_ && !recent_.empty()) {
    Entry& oldest = entries_.at(recent_.back());
    recent_bytes_ -= bytesOf(oldest);
    oldest.whole.reset();
    oldest.occupancy.reset();
    recent_.pop_back();
  }
}

bool SubmapLibrary::has(SubmapId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_.count(id) > 0;
}

SubmapPtr SubmapLibrary::light(SubmapId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_.at(id).light;
}

SubmapPtr SubmapLibrary::whole(SubmapId id) {
  std::unique_lock<std::mutex> lock(mutex_);
  Entry& entry = entries_.at(id);
  if (entry.whole) {
    if (entry.read) recent_.splice(recent_.begin(), recent_, entry.used);
    return entry.whole;
  }
  auto whole = std::make_shared<Submap>(*entry.light);
  const Read read = entry.read;
  lock.unlock();  // nobody waits for the disk who does not read
  Submap stored = read();
  if (stored.id != id || stored.points.size() != stored.normals.size())
    throw std::runtime_error("the file of submap " + std::to_string(id.value) +
                             " is not the one that was written");
  whole->points = std::move(stored.points);
  whole->normals = std::move(stored.normals);
  lock.lock();
  if (entry.whole) return entry.whole;  // another thread was faster
  entry.whole = whole;
  use(id, entry);
  return whole;
}

std::size_t SubmapLibrary::points(SubmapId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_.at(id).points;
}

SubmapPtr SubmapLibrary::inMemory(SubmapId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_.at(id).whole;
}

SubmapOccupancyPtr SubmapLibrary::occupancyInMemory(SubmapId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_.at(id).occupancy;
}

std::size_t SubmapLibrary::bytes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return recent_bytes_ + kept_bytes_;
}

}  // namespace revisit_slam
