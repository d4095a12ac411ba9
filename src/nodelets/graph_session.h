// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/loops/search/loop_search.h"
#include "revisit_slam/slam/back_end.h"
#include "revisit_slam/session/slam_files.h"

namespace revisit_slam {

/// Graph and files of one drive. Its methods throw std::runtime_error naming a file that cannot be
/// written; the graph is whole then nevertheless.
class GraphSession {
 public:
  /// With a folder for drives (live/folder) it writes into a new one in it, named by `start`.
  GraphSession(const SlamConfig& config, Stamp start, BackEnd::OnCorrection on_correction);

  void add(const GraphNode& node);
  void add(const MapUpdate& update);

  /// Does this as soon as so many scans are there: at once, or when they have been added. In order.
  void after(std::size_t scans, std::function<void()> work);
  void add(const LoopSearchResult& search);

  /// A last search and optimisation, and all files.
  void finish();
  /// What the graph says, into the folder if there is one.
  void writeGraph() const;
  /// All files, into any folder; empty: that of the session.
  void save(const std::string& folder);

  BackEnd& backEnd() { return back_end_; }
  const BackEnd& backEnd() const { return back_end_; }
  const SlamGraph& graph() const { return back_end_.graph(); }
  const std::vector<SubmapPtr>& submaps() const { return submaps_; }
  /// By SubmapId; null where occupancy is switched off.
  const std::vector<SubmapOccupancyPtr>& occupancies() const { return occupancies_; }
  /// Empty: nothing is written unless asked for.
  const std::string& folder() const { return folder_; }

 private:
  void doWhatIsDue();
  Points detailOf(const SubmapPtr& submap) const;

  MappingConfig mapping_;
  OccupancyConfig occupancy_;
  BackEnd back_end_;
  std::vector<SubmapPtr> submaps_;  // by SubmapId
  std::vector<SubmapOccupancyPtr> occupancies_;
  std::string folder_;
  std::optional<SlamFiles> files_;

  struct Later {
    std::size_t scans;
    std::function<void()> work;
  };
  std::deque<Later> later_;
};

/// How many loop constraints take part in the graph.
std::size_t activeLoops(const SlamGraph& graph);

}  // namespace revisit_slam
