// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/back_end.h"

#include <utility>

namespace revisit_slam {

BackEnd::BackEnd(const SlamConfig& config, GraphSession::OnCorrection on_correction,
                 SessionTargets targets)
    : config_(config),
      on_correction_(std::move(on_correction)),
      targets_(targets ? std::move(targets) : liveTargets(config.live)) {}

ScanOrder BackEnd::add(const GraphNode& node, const KnownMapPtr& prior) {
  const ScanOrder order = order_.take(node.id);
  if (order == ScanOrder::missed || order == ScanOrder::repeated) return order;
  if (order == ScanOrder::first) startSession(node.id.session, node.stamp, prior);
  if (!session_ || session_->id() != node.id.session) return ScanOrder::missed;  // it has failed
  session_->add(node);
  forgetEnded();
  return order;
}

void BackEnd::startSession(SessionId id, Stamp start, const KnownMapPtr& prior) {
  SessionTarget target = targets_(id, start);
  target.prior = prior;
  auto session = std::make_unique<GraphSession>(id, config_, start, target, on_correction_);
  session_ = session.get();
  sessions_[id] = std::move(session);
}

/// Never from within the work of a session.
void BackEnd::forgetEnded() {
  for (auto id = ended_.begin(); id != ended_.end();) {
    if (session_ && session_->id() == *id) {
      ++id;
      continue;
    }
    sessions_.erase(*id);
    id = ended_.erase(id);
  }
}

GraphSession* BackEnd::find(SessionId id) const {
  const auto entry = sessions_.find(id);
  return entry == sessions_.end() ? nullptr : entry->second.get();
}

std::vector<GraphSession*> BackEnd::sessions() {
  std::vector<GraphSession*> sessions;
  for (const auto& [id, session] : sessions_)
    if (session.get() == session_ || ended_.count(id) == 0) sessions.push_back(session.get());
  return sessions;
}

void BackEnd::add(const MapUpdatePtr& update) {
  if (GraphSession* session = find(update->submap->id.session)) session->add(update);
}

void BackEnd::add(const LoopClosures& closures) {
  if (GraphSession* session = find(closures.map.session)) return session->add(closures);
  if (closures.request != 0) on_correction_(unchangedMap(closures.map.session, closures.request));
}

void BackEnd::add(const MapsClosed& closed, const Done& done) {
  GraphSession* session = find(closed.session);
  if (!session) return done(nullptr, "there is nothing to finish");
  session->after(closed.scans, [this, session, closed, done] {
    if (closed.request == 0) ended_.insert(closed.session);
    done(session, "");
  });
  forgetEnded();
}

void BackEnd::reconfigure(const BackEndConfig& config) {
  config_.backend = config;
  if (session_) session_->reconfigure(config);
}

}  // namespace revisit_slam
