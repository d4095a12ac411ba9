// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "revisit_slam/slam/graph_session.h"
#include "revisit_slam/slam/session_order.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/informed_scan.h"
#include "revisit_slam/types/maps_closed.h"

namespace revisit_slam {

/// The pose graphs of session after session (paper Sec. III-D). What arrives late for a session
/// before still finds it, until its maps are closed. Its result depends on the order of what it is
/// given within each session alone. For one thread.
class BackEnd {
 public:
  /// `targets`: where sessions are written; null: as live/folder says.
  BackEnd(const SlamConfig& config, GraphSession::OnCorrection on_correction,
          SessionTargets targets = {});

  /// The first scan of another session begins its graph. Scans whose predecessors were missed are
  /// of no use, those of a base that rests add nothing. @return where the scan stands
  ScanOrder add(const InformedScan& scan) { return add(nodeOf(scan), scan.scan->goes_on_from); }
  /// `prior`: RegisteredScan::goes_on_from.
  ScanOrder add(const GraphNode& node, const KnownMapPtr& prior = {});
  void add(const MapUpdatePtr& update);
  void add(const LoopClosures& closures);

  /// Gets the session, null if there is none, and nothing or what is wrong.
  using Done = std::function<void(GraphSession*, const std::string& problem)>;

  /// Calls `done` when all scans of the session are there. Ends the session afterwards where
  /// another one has begun (MapsClosed::request 0).
  void add(const MapsClosed& closed, const Done& done);

  void reconfigure(const BackEndConfig& config);

  /// The one that runs; null before the first scan.
  GraphSession* session() { return session_; }
  const GraphSession* session() const { return session_; }
  /// Likewise, and those before whose maps are not closed yet.
  std::vector<GraphSession*> sessions();
  /// Null: there is none, or it has ended.
  GraphSession* find(SessionId id) const;

 private:
  void startSession(SessionId id, Stamp start, const KnownMapPtr& prior);
  void forgetEnded();

  SlamConfig config_;
  const GraphSession::OnCorrection on_correction_;
  const SessionTargets targets_;
  SessionOrder order_;
  std::map<SessionId, std::unique_ptr<GraphSession>>
      sessions_;                     // that are not closed, and the newest
  std::set<SessionId> ended_;        // whose maps are closed and searched
  GraphSession* session_ = nullptr;  // the newest
};

}  // namespace revisit_slam
