// SPDX-License-Identifier: MIT
#include "graph_session.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace revisit_slam {
namespace {

/// FOLDER/2024-05-17_09-30-00 (UTC), with a number behind it if there is one of that name.
std::string newFolder(const std::string& folder, Stamp start) {
  const std::time_t seconds = start.nanoseconds / 1'000'000'000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char name[32];
  std::strftime(name, sizeof(name), "%Y-%m-%d_%H-%M-%S", &utc);
  const std::string path = folder + "/" + name;
  std::string free = path;
  for (int i = 2; std::filesystem::exists(free); ++i) free = path + "_" + std::to_string(i);
  return free;
}

}  // namespace

GraphSession::GraphSession(const SlamConfig& config, Stamp start,
                           BackEnd::OnCorrection on_correction)
    : mapping_(config.mapping), occupancy_(config.occupancy), back_end_(config, std::move(on_correction)) {
  if (config.live.folder.empty()) return;
  folder_ = newFolder(config.live.folder, start);
  files_.emplace(folder_, mapping_, occupancy_);
}

void GraphSession::add(const GraphNode& node) {
  back_end_.add(node);
  doWhatIsDue();
}

void GraphSession::add(const MapUpdate& update) {
  submaps_.push_back(update.submap);
  occupancies_.push_back(update.occupancy);
  if (files_) files_->add(update);
}

void GraphSession::add(const LoopSearchResult& search) {
  after(search.map->submaps.back()->lastScan().value + 1, [this, search] {
    back_end_.add(search.map, search.accepted());
    writeGraph();
  });
}

void GraphSession::after(std::size_t scans, std::function<void()> work) {
  later_.push_back({scans, std::move(work)});
  doWhatIsDue();
}

void GraphSession::doWhatIsDue() {
  while (!later_.empty() && later_.front().scans <= graph().size()) {
    const Later due = std::move(later_.front());
    later_.pop_front();
    due.work();
  }
}

void GraphSession::finish() {
  back_end_.finish();
  if (files_) save("");
}

void GraphSession::writeGraph() const {
  if (files_) files_->writeGraphFiles(back_end_);
}

void GraphSession::save(const std::string& folder) {
  if (folder.empty() && !files_)
    throw std::runtime_error("no folder: give one, or set live/folder");
  if (folder.empty() || folder == folder_) {
    submaps_.empty() ? files_->writeGraphFiles(back_end_) : files_->write(back_end_);
    return;
  }
  SlamFiles files(folder, mapping_, occupancy_);
  for (std::size_t i = 0; i < submaps_.size(); ++i)
    files.add({submaps_[i], detailOf(submaps_[i]), occupancies_[i], nullptr});
  submaps_.empty() ? files.writeGraphFiles(back_end_) : files.write(back_end_);
}

/// As finely as there is something: a session without files keeps the points of submaps alone.
Points GraphSession::detailOf(const SubmapPtr& submap) const {
  return files_ ? files_->detail(submap->id) : submap->points;
}

std::size_t activeLoops(const SlamGraph& graph) {
  return static_cast<std::size_t>(
      std::count_if(graph.loops().begin(), graph.loops().end(),
                    [](const LoopEdge& edge) { return edge.state == LoopState::active; }));
}

}  // namespace revisit_slam
