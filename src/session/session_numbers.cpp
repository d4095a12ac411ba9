// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_numbers.h"

#include <memory>
#include <utility>

namespace revisit_slam {

GraphNode SessionNumbers::operator()(GraphNode node) const {
  node.id = (*this)(node.id);
  for (GnssFix& fix : node.fixes) fix.scan = (*this)(fix.scan);
  if (node.gravity) node.gravity->scan = (*this)(node.gravity->scan);
  return node;
}

LoopEdge SessionNumbers::operator()(LoopEdge edge) const {
  LoopConstraint& loop = edge.loop;
  loop.constraint.from = (*this)(loop.constraint.from);
  loop.constraint.to = (*this)(loop.constraint.to);
  loop.target = (*this)(loop.target);
  loop.source = (*this)(loop.source);
  loop.target_map = (*this)(loop.target_map);
  loop.source_map = (*this)(loop.source_map);
  return edge;
}

SubmapClosed SessionNumbers::operator()(SubmapClosed submap) const {
  submap.id = (*this)(submap.id);
  submap.local_map = (*this)(submap.local_map);
  submap.first_scan = (*this)(submap.first_scan);
  submap.last_scan = (*this)(submap.last_scan);
  return submap;
}

Submap SessionNumbers::operator()(Submap submap) const {
  submap.id = (*this)(submap.id);
  submap.local_map = (*this)(submap.local_map);
  submap.first_scan = (*this)(submap.first_scan);
  return submap;
}

MapUpdate SessionNumbers::operator()(const MapUpdate& update) const {
  MapUpdate renamed = update;
  renamed.submap = std::make_shared<const Submap>((*this)(*update.submap));
  return renamed;
}

StoredLocalMap SessionNumbers::operator()(StoredLocalMap map) const {
  map.id = (*this)(map.id);
  for (SubmapId& submap : map.submaps) submap = (*this)(submap);
  return map;
}

}  // namespace revisit_slam
