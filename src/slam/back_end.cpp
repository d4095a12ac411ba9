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

/// The session before lives on until its last maps have come.
void BackEnd::startSession(SessionId id, Stamp start) {
  if (session_) session_->writeGraph();
  before_ = std::move(session_);
  session_ = std::make_unique<GraphSession>(id, config_, start, on_correction_);
}

GraphSession* BackEnd::find(SessionId id) const {
  for (const auto* session : {&session_, &before_})
    if (*session && (*session)->id() == id) return session->get();
  return nullptr;
}

void BackEnd::add(const MapUpdate& update) {
  if (GraphSession* session = find(update.submap->id.session)) session->add(update);
}

void BackEnd::add(const LoopClosures& closures) {
  if (GraphSession* session = find(closures.map.session)) session->add(closures);
}

void BackEnd::add(const MapsClosed& closed, const std::function<void(const std::string&)>& done) {
  GraphSession* session = find(closed.session);
  if (!session) return done("there is nothing to finish");
  session->after(closed.scans, [session, done] {
    std::string problem;
    try {
      session->saveOwn();
    } catch (const std::exception& error) {
      problem = error.what();
    }
    done(problem);
  });
  if (session == before_.get()) before_.reset();
}

void BackEnd::reconfigure(const BackEndConfig& config) {
  config_.backend = config;
  if (session_) session_->reconfigure(config);
}

}  // namespace revisit_slam
