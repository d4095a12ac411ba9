// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/graph_session.h"

#include <algorithm>
#include <ctime>
#include <exception>
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

GraphSession::GraphSession(SessionId id, const SlamConfig& config, Stamp start,
                           OnCorrection on_correction)
    : id_(id),
      mapping_(config.mapping),
      occupancy_(config.occupancy),
      graph_(config.backend),
      on_correction_(std::move(on_correction)) {
  if (config.live.folder.empty()) return;
  try {
    folder_ = newFolder(config.live.folder, start);
    files_.emplace(folder_, mapping_, occupancy_);
  } catch (const std::exception& error) {
    problem_ = error.what();
    folder_.clear();
  }
}

void GraphSession::add(const GraphNode& node) {
  graph_.add(node);
  doWhatIsDue();
}

void GraphSession::add(const MapUpdate& update) {
  submaps_.push_back(update.submap);
  occupancies_.push_back(update.occupancy);
  if (files_) files_->add(update);
}

void GraphSession::add(const LoopClosures& closures) {
  after(closures.last_scan.value + 1, [this, closures] {
    last_optimised_ = closures.last_scan;
    if (!closures.constraints.empty())
      optimise(closures.last_scan, closures.constraints, closures.request);
    writeGraph();
  });
}

void GraphSession::after(std::size_t scans, std::function<void()> work) {
  later_.push_back({scans, std::move(work)});
  doWhatIsDue();
}

/// All of it, whatever throws; the first that was thrown is thrown at the end.
void GraphSession::doWhatIsDue() {
  std::exception_ptr error;
  while (!later_.empty() && later_.front().scans <= graph_.size()) {
    const Later due = std::move(later_.front());
    later_.pop_front();
    try {
      due.work();
    } catch (...) {
      if (!error) error = std::current_exception();
    }
  }
  if (error) std::rethrow_exception(error);
}

/// Answers in any case: the map manager waits for it.
void GraphSession::optimise(ScanId last, const std::vector<LoopConstraint>& loops,
                            std::uint32_t request) {
  std::exception_ptr error;
  try {
    const bool taken = graph_.optimise(last, loops);
    ++count_.optimisations;
    count_.seconds += graph_.lastSolution().seconds;
    if (!taken) ++count_.rejected;
  } catch (...) {
    error = std::current_exception();
  }
  answer(last, request);
  if (error) std::rethrow_exception(error);
}

void GraphSession::answer(ScanId last, std::uint32_t request) {
  MapCorrection correction;
  correction.session = id_;
  correction.version = ++version_;
  correction.request = request;
  for (std::uint32_t i = 0; i <= last.value; ++i)
    correction.T_map_scan.push_back(graph_.pose({i, id_}));
  correction.T_map_odom = graph_.T_map_odom();
  correction.loops = graph_.loops();
  correction.moved_end = graph_.movedEnd();
  correction.seconds = graph_.lastSolution().seconds;
  on_correction_(std::make_shared<const MapCorrection>(std::move(correction)));
}

bool GraphSession::disable(LoopId id) {
  if (!graph_.disable(id)) return false;
  optimise(*last_optimised_, {}, 0);
  return true;
}

void GraphSession::writeGraph() const {
  if (files_) files_->writeGraphFiles(graph_);
}

void GraphSession::saveOwn() {
  if (files_) save("");
}

void GraphSession::save(const std::string& folder) {
  if (folder.empty() && !files_)
    throw std::runtime_error("no folder: give one, or set live/folder");
  if (folder.empty() || folder == folder_) {
    submaps_.empty() ? files_->writeGraphFiles(graph_) : files_->write(graph_);
    return;
  }
  SlamFiles files(folder, mapping_, occupancy_);
  for (std::size_t i = 0; i < submaps_.size(); ++i)
    files.add({submaps_[i], detailOf(submaps_[i]), occupancies_[i], nullptr});
  submaps_.empty() ? files.writeGraphFiles(graph_) : files.write(graph_);
}

/// As finely as there is something: a session without files keeps the points of submaps alone.
Points GraphSession::detailOf(const SubmapPtr& submap) const {
  return files_ ? files_->detail(submap->id) : submap->points;
}

void requireFolder(const LiveConfig& live) {
  std::error_code error;
  if (!live.folder.empty()) std::filesystem::create_directories(live.folder, error);
  if (error)
    throw ParameterError("live/folder is '" + live.folder +
                         "', but cannot be made: " + error.message());
}

std::size_t activeLoops(const SlamGraph& graph) {
  return static_cast<std::size_t>(
      std::count_if(graph.loops().begin(), graph.loops().end(),
                    [](const LoopEdge& edge) { return edge.state == LoopState::active; }));
}

}  // namespace revisit_slam
