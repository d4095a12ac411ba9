// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/session/session_reader.h"
#include "revisit_slam/session/stored_local_map.h"

namespace revisit_slam {

/// What the sessions of a folder are called in another one, where there are others, too. Numbers of
/// scans, submaps and local maps stay.
class SessionNumbers {
 public:
  /// Those of the folder in order, from `first` on, or else as they are.
  SessionNumbers(const std::vector<SessionId>& sessions, std::optional<SessionId> first) {
    for (const SessionId session : sessions) {
      new_[session] = first.value_or(session);
      if (first) ++first->value;
    }
  }

  std::size_t size() const { return new_.size(); }

  SessionId operator()(SessionId session) const { return new_.at(session); }
  template <typename Tag>
  Id<Tag> operator()(Id<Tag> id) const {
    return {id.value, new_.at(id.session)};
  }
  GraphNode operator()(GraphNode node) const;
  LoopEdge operator()(LoopEdge edge) const;
  SubmapClosed operator()(SubmapClosed submap) const;
  Submap operator()(Submap submap) const;
  MapUpdate operator()(const MapUpdate& update) const;
  StoredLocalMap operator()(StoredLocalMap map) const;

 private:
  std::map<SessionId, SessionId> new_;  // by old one
};

}  // namespace revisit_slam
