// SPDX-License-Identifier: MIT
#include "revisit_slam/session/graph_log.h"

#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "loop_bytes.h"
#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/io/bytes.h"
#include "revisit_slam/io/record_file.h"
#include "submap_bounds.h"

namespace revisit_slam {
namespace {

constexpr char kKind[] = "RSGRAPH\n";
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kNoLoop = ~std::uint32_t{0};

enum Type : std::uint32_t {
  kSubmap = 1,
  kScans = 2,
  kOptimised = 3,
  kTrajectory = 4,
  kParameters = 5,
  kTakenOver = 6,
  kFixes = 7,
  kGeoreferenced = 8,
  kDirections = 9
};

template <typename Element>
void putCount(const std::vector<Element>& elements, ByteWriter& bytes) {
  bytes.put(static_cast<std::uint32_t>(elements.size()));
}

Type put(const SubmapClosed& submap, ByteWriter& bytes) {
  bytes.put(submap.id);
  bytes.put(submap.local_map);
  bytes.put(submap.first_scan);
  bytes.put(submap.last_scan);
  bytes.put(submap.stamp);
  for (const Eigen::Vector3f& corner : {submap.box_submap.min(), submap.box_submap.max()})
    for (int axis = 0; axis < 3; ++axis) bytes.put(corner[axis]);
  return kSubmap;
}

SubmapClosed getSubmap(ByteReader& bytes) {
  SubmapClosed submap;
  submap.id = bytes.id<SubmapId>();
  submap.local_map = bytes.id<LocalMapId>();
  submap.first_scan = bytes.id<ScanId>();
  submap.last_scan = bytes.id<ScanId>();
  submap.stamp = bytes.stamp();
  for (Eigen::Vector3f* corner : {&submap.box_submap.min(), &submap.box_submap.max()})
    for (int axis = 0; axis < 3; ++axis) (*corner)[axis] = bytes.get<float>();
  if (!submap.box_submap.isEmpty() &&
      (!isInBounds(submap.box_submap.min()) || !isInBounds(submap.box_submap.max())))
    throw std::runtime_error("a submap has no bounds");
  return submap;
}

Type put(const ScansAdded& scans, ByteWriter& bytes) {
  for (const GraphNode& node : scans.nodes) {
    bytes.put(node.id);
    bytes.put(node.stamp);
    bytes.put(node.T_odom_base);
    bytes.put(node.information);
  }
  return kScans;
}

ScansAdded getScans(ByteReader& bytes) {
  ScansAdded scans;
  while (bytes.left() > 0) {
    GraphNode& node = scans.nodes.emplace_back();
    node.id = bytes.id<ScanId>();
    node.stamp = bytes.stamp();
    node.T_odom_base = bytes.pose();
    node.information = bytes.matrix();
  }
  return scans;
}

Type put(const GraphOptimised& optimised, ByteWriter& bytes) {
  bytes.put(optimised.version);
  bytes.put(optimised.last_scan);
  bytes.put(optimised.disabled ? optimised.disabled->value : kNoLoop);
  bytes.put(optimised.T_map_odom);
  putCount(optimised.constraints, bytes);
  for (const LoopConstraint& loop : optimised.constraints) put(loop, bytes);
  putCount(optimised.T_map_keypose, bytes);
  for (const Pose& T : optimised.T_map_keypose) bytes.put(T);
  for (const GraphOptimised::Decision& decision : optimised.decisions) put(decision, bytes);
  return kOptimised;
}

GraphOptimised getOptimised(ByteReader& bytes) {
  GraphOptimised optimised;
  optimised.version = bytes.get<std::uint32_t>();
  optimised.last_scan = bytes.id<ScanId>();
  const auto disabled = bytes.get<std::uint32_t>();
  if (disabled != kNoLoop) optimised.disabled = LoopId{disabled, optimised.last_scan.session};
  optimised.T_map_odom = bytes.pose();
  for (auto n = bytes.get<std::uint32_t>(); n > 0; --n)
    optimised.constraints.push_back(getLoop(bytes));
  for (auto n = bytes.get<std::uint32_t>(); n > 0; --n)
    optimised.T_map_keypose.push_back(bytes.pose());
  while (bytes.left() > 0) optimised.decisions.push_back(getDecision(bytes));
  return optimised;
}

Type put(const TrajectoryWritten& trajectory, ByteWriter& bytes) {
  bytes.put(trajectory.version);
  for (const Pose& T : trajectory.T_map_scan) bytes.put(T);
  return kTrajectory;
}

TrajectoryWritten getTrajectory(ByteReader& bytes) {
  TrajectoryWritten trajectory;
  trajectory.version = bytes.get<std::uint32_t>();
  while (bytes.left() > 0) trajectory.T_map_scan.push_back(bytes.pose());
  return trajectory;
}

/// Lines "name=value", as on a command line.
Type put(const ParametersChanged& changed, ByteWriter& bytes) {
  std::string text;
  for (const auto& [name, value] : changed.values)
    text.append(name).append("=").append(value) += '\n';
  bytes.putAll(std::vector<char>(text.begin(), text.end()));
  return kParameters;
}

ParametersChanged getParameters(ByteReader& bytes) {
  ParametersChanged changed;
  std::string line;
  for (const char letter : bytes.rest<char>()) {
    if (letter != '\n') {
      line += letter;
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) throw std::runtime_error("a parameter without a value");
    changed.values.emplace_back(line.substr(0, equals), line.substr(equals + 1));
    line.clear();
  }
  return changed;
}

Type put(const SessionsTakenOver& taken, ByteWriter& bytes) {
  putCount(taken.loops, bytes);
  for (const LoopEdge& edge : taken.loops) {
    put(edge.loop, bytes);
    put(decisionOf(edge), bytes);
  }
  for (const Pose& T : taken.T_map_scan) bytes.put(T);
  return kTakenOver;
}

SessionsTakenOver getTakenOver(ByteReader& bytes) {
  SessionsTakenOver taken;
  for (auto n = bytes.get<std::uint32_t>(); n > 0; --n) {
    LoopEdge& edge = taken.loops.emplace_back();
    edge.id = LoopId{static_cast<std::uint32_t>(taken.loops.size() - 1)};
    edge.loop = getLoop(bytes);
    decide(getDecision(bytes), edge);
  }
  while (bytes.left() > 0) taken.T_map_scan.push_back(bytes.pose());
  return taken;
}

void put(const GeodeticPosition& position, ByteWriter& bytes) {
  bytes.put(position.latitude);
  bytes.put(position.longitude);
  bytes.put(position.altitude);
}

GeodeticPosition getPosition(ByteReader& bytes) {
  GeodeticPosition position;
  position.latitude = bytes.get<double>();
  position.longitude = bytes.get<double>();
  position.altitude = bytes.get<double>();
  if (!isValid(position)) throw std::runtime_error("a record has a position that is none");
  return position;
}

Type put(const FixesAdded& added, ByteWriter& bytes) {
  for (const auto& [carrier, fix] : added.fixes) {
    bytes.put(carrier);
    bytes.put(fix.stamp);
    bytes.put(fix.scan);
    for (int axis = 0; axis < 3; ++axis) bytes.put(fix.p_scan[axis]);
    put(fix.position, bytes);
    for (int i = 0; i < 9; ++i) bytes.put(fix.covariance_enu(i / 3, i % 3));
  }
  return kFixes;
}

FixesAdded getFixes(ByteReader& bytes) {
  FixesAdded added;
  while (bytes.left() > 0) {
    auto& [carrier, fix] = added.fixes.emplace_back();
    carrier = bytes.id<ScanId>();
    fix.stamp = bytes.stamp();
    fix.scan = bytes.id<ScanId>();
    for (int axis = 0; axis < 3; ++axis) fix.p_scan[axis] = bytes.get<double>();
    fix.position = getPosition(bytes);
    for (int i = 0; i < 9; ++i) fix.covariance_enu(i / 3, i % 3) = bytes.get<double>();
    const bool is_weighed = fix.covariance_enu.allFinite() &&
                            fix.covariance_enu.diagonal().minCoeff() > 1e-12 &&
                            fix.covariance_enu.llt().info() == Eigen::Success;
    if (!isInBounds(fix.p_scan.cast<float>()) || !is_weighed || carrier < fix.scan ||
        carrier.session != fix.scan.session)
      throw std::runtime_error("a record has a position that is none");
  }
  return added;
}

Type put(const MapGeoreferenced& entry, ByteWriter& bytes) {
  bytes.put(entry.version);
  put(entry.georeference.datum, bytes);
  bytes.put(entry.georeference.T_enu_map);
  bytes.put(entry.georeference.yaw_deviation);
  bytes.put(static_cast<std::uint32_t>(entry.georeference.fixes));
  bytes.put(static_cast<std::uint32_t>(entry.georeference.outliers));
  return kGeoreferenced;
}

MapGeoreferenced getGeoreferenced(ByteReader& bytes) {
  MapGeoreferenced entry;
  entry.version = bytes.get<std::uint32_t>();
  entry.georeference.datum = getPosition(bytes);
  entry.georeference.T_enu_map = bytes.pose();
  entry.georeference.yaw_deviation = bytes.get<double>();
  entry.georeference.fixes = bytes.get<std::uint32_t>();
  entry.georeference.outliers = bytes.get<std::uint32_t>();
  return entry;
}

Type put(const DirectionsAdded& added, ByteWriter& bytes) {
  for (const auto& [carrier, direction] : added.directions) {
    bytes.put(carrier);
    bytes.put(direction.scan);
    for (int axis = 0; axis < 3; ++axis) bytes.put(direction.up_base[axis]);
  }
  return kDirections;
}

DirectionsAdded getDirections(ByteReader& bytes) {
  DirectionsAdded added;
  while (bytes.left() > 0) {
    auto& [carrier, direction] = added.directions.emplace_back();
    carrier = bytes.id<ScanId>();
    direction.scan = bytes.id<ScanId>();
    for (int axis = 0; axis < 3; ++axis) direction.up_base[axis] = bytes.get<double>();
    if (!(std::abs(direction.up_base.norm() - 1.0) < 1e-6) || carrier < direction.scan ||
        carrier.session != direction.scan.session)
      throw std::runtime_error("a record has a direction that is none");
  }
  return added;
}

/// Those of the scans.
FixesAdded fixesOf(const ScansAdded& scans) {
  FixesAdded added;
  for (const GraphNode& node : scans.nodes)
    for (const GnssFix& fix : node.fixes) added.fixes.emplace_back(node.id, fix);
  return added;
}

DirectionsAdded directionsOf(const ScansAdded& scans) {
  DirectionsAdded added;
  for (const GraphNode& node : scans.nodes)
    if (node.gravity) added.directions.emplace_back(node.id, *node.gravity);
  return added;
}

std::optional<LogEntry> decode(const Record& record) {
  ByteReader bytes(record.payload);
  switch (record.type) {
    case kSubmap:
      return getSubmap(bytes);
    case kScans:
      return getScans(bytes);
    case kOptimised:
      return getOptimised(bytes);
    case kTrajectory:
      return getTrajectory(bytes);
    case kParameters:
      return getParameters(bytes);
    case kTakenOver:
      return getTakenOver(bytes);
    case kFixes:
      return getFixes(bytes);
    case kGeoreferenced:
      return getGeoreferenced(bytes);
    case kDirections:
      return getDirections(bytes);
    default:
      return std::nullopt;  // of a later version, which says that older ones can do without
  }
}

}  // namespace

SubmapClosed closedOf(const Submap& submap, const Points& detail_submap) {
  SubmapClosed closed{submap.id,         submap.local_map,      submap.first_scan,
                      submap.lastScan(), submap.stamps.front(), {}};
  for (const Eigen::Vector3f& point : detail_submap) closed.box_submap.extend(point);
  return closed;
}

GraphOptimised::Decision decisionOf(const LoopEdge& edge) {
  return {edge.state, edge.chi2_before, edge.chi2_after, edge.weight};
}

void decide(const GraphOptimised::Decision& decision, LoopEdge& edge) {
  edge.state = decision.state;
  edge.chi2_before = decision.chi2_before;
  edge.chi2_after = decision.chi2_after;
  edge.weight = decision.weight;
}

bool belongsToDrive(const LogEntry& entry) {
  return std::holds_alternative<SubmapClosed>(entry) || std::holds_alternative<ScansAdded>(entry) ||
         std::holds_alternative<FixesAdded>(entry) ||
         std::holds_alternative<DirectionsAdded>(entry);
}

std::string graphLogHeader() {
  return recordFileHeader(kKind, kVersion);
}

std::string encodeEntry(const LogEntry& entry) {
  if (const auto* scans = std::get_if<ScansAdded>(&entry)) {
    const FixesAdded fixes = fixesOf(*scans);
    const DirectionsAdded directions = directionsOf(*scans);
    ByteWriter bytes;
    const Type type = put(*scans, bytes);
    return (fixes.fixes.empty() ? "" : encodeEntry(fixes)) +
           (directions.directions.empty() ? "" : encodeEntry(directions)) +
           encodeRecord({type, bytes.bytes()});
  }
  ByteWriter bytes;
  const Type type = std::visit([&](const auto& what) { return put(what, bytes); }, entry);
  return encodeRecord({type, bytes.bytes()});
}

GraphLog readGraphLog(const std::string& path) {
  RecordFile file = readRecordFile(path, kKind, kVersion);
  GraphLog log;
  log.damage = std::move(file.damage);
  try {
    for (const Record& record : file.records)
      if (std::optional<LogEntry> entry = decode(record)) log.entries.push_back(std::move(*entry));
  } catch (const std::runtime_error& error) {  // whole, and written by something else
    log.damage = path + ": after entry " + std::to_string(log.entries.size()) + ": " +
                 error.what() + "; what follows is left out";
  }
  return log;
}

}  // namespace revisit_slam
