// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/session/map_export.h"
#include "revisit_slam/session/run_summary.h"
#include "revisit_slam/slam/session_log.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/loop_closures.h"

namespace revisit_slam {

/// How much the optimiser has done.
struct OptimisationCount {
  int optimisations = 0;
  int rejected = 0;
  double seconds = 0.0;
};

/// Graph and files of one session (paper Sec. III-D), which may go on from others that were mapped
/// before (SessionTarget::prior): factors in, corrections out. What cannot be written waits
/// (SessionWriter), and nothing else does.
class GraphSession {
 public:
  using OnCorrection = std::function<void(const MapCorrectionPtr&)>;

  GraphSession(SessionId id, const SlamConfig& config, Stamp start, const SessionTarget& target,
               OnCorrection on_correction);
  /// Everything known is written.
  ~GraphSession();

  SessionId id() const { return id_; }

  void add(const GraphNode& node);
  void add(const MapUpdatePtr& update);
  /// Optimises when the scans up to the closures' last are there, and answers with a correction.
  void add(const LoopClosures& closures);
  /// Does this as soon as so many scans of the session are there: at once, or when they have been
  /// added. In order.
  void after(std::size_t scans, std::function<void()> work);

  /// Leaves a loop out and optimises without it. @return whether there was one to leave out.
  bool disable(LoopId id);

  void reconfigure(const BackEndConfig& config);

  /// Makes all files that can be made of the session by now, in its folder if there is one.
  /// @return what could not be made, and why. @throws std::runtime_error naming what cannot be
  /// written.
  std::vector<std::string> saveOwn(const ExportProgress& progress = {});
  /// The session and all files made of it in another folder, which gets a number behind its name if
  /// it is in use already; a relative one is in live/folder. @return where they are.
  /// @throws std::runtime_error naming what cannot be written.
  std::string save(const std::string& folder);
  /// Writes what is known, scans in the open submap included, and what the graph says: fast, for
  /// the end of a process. @throws std::runtime_error naming what cannot be written.
  void writeRest();

  /// What the graph knows for run.json.
  void tell(RunSummary& summary) const;
  /// run.json in the folder if there is one: with what the graph knows, and what is known of scans.
  /// @throws std::runtime_error
  void writeSummary(RunSummary summary) const;

  /// The session as it is now, for exports; its submaps are those in the folder.
  Session snapshot() const { return log_.snapshot(); }

  const SlamGraph& graph() const { return graph_; }
  const OptimisationCount& count() const { return count_; }
  /// By number; without points.
  const std::vector<SubmapPtr>& submaps() const { return log_.submaps(); }
  /// With points. @throws std::runtime_error where they cannot be read.
  SubmapPtr whole(const Submap& submap) const { return log_.whole(submap); }
  std::size_t pointsOf(const Submap& submap) const { return log_.pointsOf(submap); }
  /// Null where occupancy is switched off, or cannot be read.
  SubmapOccupancyPtr occupancy(const Submap& submap) const { return log_.occupancy(submap); }
  /// What the session goes on from; null: nothing.
  const KnownMapPtr& prior() const { return log_.prior(); }
  /// Whether it is known where the session lies in the map: it goes on from none, or loops tie it
  /// to the one that it goes on from.
  bool isPlaced() const;
  /// Whether this scan of the session is in the graph.
  bool has(ScanId scan) const { return scans_before_ + scan.value < graph_.size(); }
  /// How many scans of sessions that were mapped before are in the graph, the first ones.
  std::size_t scansBefore() const { return scans_before_; }
  /// Empty: nothing is written unless asked for.
  const std::string& folder() const { return log_.folder(); }
  /// Why something waits to be written; empty: nothing does.
  std::string problem() const { return log_.problem(); }
  /// What the disk has not taken yet.
  WriterBacklog backlog() const { return log_.backlog(); }
  /// Whether every scan is in a submap that is closed.
  bool isWhole() const { return log_.isWhole(); }

 private:
  void optimise(ScanId last, const std::vector<LoopConstraint>& loops, std::uint32_t request,
                std::optional<LoopId> disabled = {});
  void take(const LoopClosures& closures);
  void answer(ScanId last, std::uint32_t request);
  void doWhatIsDue();

  const SessionId id_;
  SlamConfig config_;
  SlamGraph graph_;
  const std::size_t scans_before_;  // of sessions that were mapped before
  const OnCorrection on_correction_;
  std::uint32_t version_ = 0;
  std::uint32_t answered_ = 0;            // the last request that was
  std::optional<ScanId> last_optimised_;  // may also have come without loops
  OptimisationCount count_;

  SessionLog log_;
  std::vector<LocalMapPtr> unsearched_;  // local maps

  struct Later {
    std::size_t scans;
    std::function<void()> work;
  };
  std::deque<Later> later_;
};

/// How many loop constraints take part in the graph.
std::size_t activeLoops(const SlamGraph& graph);

}  // namespace revisit_slam
