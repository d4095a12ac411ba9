// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/back_end.h"

#include <exception>
#include <utility>

namespace revisit_slam {

BackEnd::BackEnd(const SlamConfig& config, GraphSession::OnCorrection on_correction)
    : config_(config), on_correction_(std::move(on_correction)) {}

ScanOrder BackEnd::add(const GraphNode& node) {
  const ScanOrder order = order_.take(node.id);
  if (order == ScanOrder::missed) return order;
  if (order == ScanOrder::first) startSession(node.id.session, node.stamp);
  session_->add(node);
  return order;
}

void BackEnd::startSession(SessionId id, Stamp start) {
  if (session_) session_->writeGraph();
  auto& session = sessions_[id];
  session = std::make_unique<GraphSession>(id, config_, start, on_correction_);
  session_ = session.get();
}

GraphSession* BackEnd::find(SessionId id) const {
  const auto entry = sessions_.find(id);
  return entry == sessions_.end() ? nullptr : entry->second.get();
}

void BackEnd::add(const MapUpdate& update) {
  if (GraphSession* session = find(update.submap->id.session)) session->add(update);
}

void BackEnd::add(const LoopClosures& closures) {
  if (GraphSession* session = find(closures.map.session)) session->add(closures);
}

void BackEnd::add(const MapsClosed& closed, const Done& done) {
  GraphSession* session = find(closed.session);
  if (!session) return done(nullptr, "there is nothing to finish");
  const auto is_saved = std::make_shared<bool>(false);
  session->after(closed.scans, [session, done, is_saved] {
    *is_saved = true;
    std::string problem;
    try {
      session->saveOwn();
    } catch (const std::exception& error) {
      problem = error.what();
    }
    done(session, problem);
  });
  if (*is_saved && session != session_) sessions_.erase(closed.session);
}

void BackEnd::reconfigure(const BackEndConfig& config) {
  config_.backend = config;
  if (session_) session_->reconfigure(config);
}

}  // namespace revisit_slam
