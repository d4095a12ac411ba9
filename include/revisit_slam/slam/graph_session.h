// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/session/slam_files.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/loop_closures.h"

namespace revisit_slam {

/// How much the optimiser has done.
struct OptimisationCount {
  int optimisations = 0;
  int rejected = 0;
  double seconds = 0.0;
};

/// Graph and files of one session (paper Sec. III-D): factors in, corrections out. Its methods
/// throw std::runtime_error naming a file that cannot be written; the graph is whole then
/// nevertheless.
class GraphSession {
 public:
  using OnCorrection = std::function<void(const MapCorrectionPtr&)>;

  /// With a folder for drives (live/folder) it writes into a new one in it, named by `start`. Where
  /// that cannot be made it goes on without files, and problem() says why.
  GraphSession(SessionId id, const SlamConfig& config, Stamp start, OnCorrection on_correction);

  SessionId id() const { return id_; }

  void add(const GraphNode& node);
  void add(const MapUpdate& update);
  /// Optimises when the scans up to the closures' last are there, and answers with a correction.
  void add(const LoopClosures& closures);
  /// Does this as soon as so many scans are there: at once, or when they have been added. In order.
  void after(std::size_t scans, std::function<void()> work);

  /// Leaves a loop out and optimises without it. @return whether there was one to leave out.
  bool disable(LoopId id);

  void reconfigure(const BackEndConfig& config) { graph_.reconfigure(config); }

  /// What the graph says, into the folder if there is one.
  void writeGraph() const;
  /// All files, into any folder; empty: that of the session.
  void save(const std::string& folder);
  /// All files, into the folder if there is one.
  void saveOwn();

  const SlamGraph& graph() const { return graph_; }
  const OptimisationCount& count() const { return count_; }
  const std::vector<SubmapPtr>& submaps() const { return submaps_; }
  /// By number; null where occupancy is switched off.
  const std::vector<SubmapOccupancyPtr>& occupancies() const { return occupancies_; }
  /// Empty: nothing is written unless asked for.
  const std::string& folder() const { return folder_; }
  const std::string& problem() const { return problem_; }

 private:
  void optimise(ScanId last, const std::vector<LoopConstraint>& loops, std::uint32_t request);
  void answer(ScanId last, std::uint32_t request);
  void doWhatIsDue();
  Points detailOf(const SubmapPtr& submap) const;

  const SessionId id_;
  MappingConfig mapping_;
  OccupancyConfig occupancy_;
  SlamGraph graph_;
  const OnCorrection on_correction_;
  std::uint32_t version_ = 0;
  std::optional<ScanId> last_optimised_;
  OptimisationCount count_;

  std::vector<SubmapPtr> submaps_;  // by number
  std::vector<SubmapOccupancyPtr> occupancies_;
  std::string folder_, problem_;
  std::optional<SlamFiles> files_;

  struct Later {
    std::size_t scans;
    std::function<void()> work;
  };
  std::deque<Later> later_;
};

/// Makes live/folder. @throws ParameterError where that is not possible.
void requireFolder(const LiveConfig& live);

/// How many loop constraints take part in the graph.
std::size_t activeLoops(const SlamGraph& graph);

}  // namespace revisit_slam
