// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_summary.h"

#include <set>
#include <stdexcept>
#include <utility>

#include "loop_bytes.h"
#include "revisit_slam/pose_graph/chain_piece.h"
#include "revisit_slam/session/stored_submap.h"

namespace revisit_slam {
namespace {

constexpr char kKind[] = "RSSUMMRY";
constexpr std::uint32_t kVersion = 2;
// Behind those of local maps; 4 were submaps without `weak_height`.
constexpr std::uint32_t kSession = 3, kLoops = 5, kSubmaps = 6;

/// The odometry from one scan to a later one as one edge.
Matrix6 informationBetween(const std::vector<GraphNode>& nodes, std::size_t first,
                           std::size_t last) {
  std::vector<RelativePoseFactor> links;
  for (std::size_t i = first + 1; i <= last; ++i)
    links.push_back(
        {{NodeId{static_cast<std::uint32_t>(i - 1)}, NodeId{static_cast<std::uint32_t>(i)}},
         nodes[i - 1].T_odom_base.inverse() * nodes[i].T_odom_base,
         nodes[i].information});
  ChainPiece piece;
  for (const RelativePoseFactor& link : links) piece.push_back(&link);
  return composed(piece).information;
}

std::vector<SummarisedSubmap> submapsOf(const Session& session) {
  const SessionOffsets<ScanId> scans = scansOf(session.graph);
  std::vector<SummarisedSubmap> submaps;
  std::size_t before = 0;
  for (const SubmapClosed& closed : session.submaps) {
    const SubmapPtr stored =
        readSubmap(submapFile(session.folder, closed.id), {SubmapRecord::submap}).submap;
    const std::size_t first = scans[closed.first_scan];
    SummarisedSubmap& submap = submaps.emplace_back();
    submap.id = closed.id;
    submap.local_map = closed.local_map;
    submap.first_scan = closed.first_scan;
    submap.stamp = closed.stamp;
    submap.travelled_begin = stored->travelled_begin;
    submap.unsure_begin = stored->unsure_begin;
    submap.T_odom_submap = session.graph.nodes[first].T_odom_base;
    submap.T_map_submap = session.graph.T_map_scan[first];
    if (submaps.size() > 1)
      submap.information = informationBetween(session.graph.nodes, before, first);
    before = first;
  }
  return submaps;
}

std::vector<StoredLocalMap> placesOf(const Session& session, std::vector<std::string>& notices) {
  std::set<LocalMapId> ids;
  for (const SubmapClosed& submap : session.submaps) ids.insert(submap.local_map);
  std::vector<StoredLocalMap> places;
  for (const LocalMapId id : ids) {
    try {
      places.push_back(readLocalMap(localMapFile(session.folder, id, session.info.id)));
    } catch (const std::runtime_error& error) {
      notices.push_back("place " + std::to_string(id.value) +
                        " is not recognised: " + error.what());
    }
  }
  return places;
}

std::string encode(const std::vector<SummarisedSubmap>& submaps) {
  ByteWriter bytes;
  for (const SummarisedSubmap& submap : submaps) {
    bytes.put(submap.id);
    bytes.put(submap.local_map);
    bytes.put(submap.first_scan);
    bytes.put(submap.stamp);
    bytes.put(submap.travelled_begin);
    bytes.put(submap.unsure_begin.weak);
    bytes.put(submap.unsure_begin.weak_height);
    bytes.put(submap.unsure_begin.doubt);
    bytes.put(submap.T_odom_submap);
    bytes.put(submap.T_map_submap);
    bytes.put(submap.information);
  }
  return bytes.bytes();
}

std::vector<SummarisedSubmap> decodeSubmaps(const std::string& payload) {
  ByteReader bytes(payload);
  std::vector<SummarisedSubmap> submaps;
  while (bytes.left() > 0) {
    SummarisedSubmap& submap = submaps.emplace_back();
    submap.id = bytes.id<SubmapId>();
    submap.local_map = bytes.id<LocalMapId>();
    submap.first_scan = bytes.id<ScanId>();
    submap.stamp = bytes.stamp();
    submap.travelled_begin = bytes.get<double>();
    submap.unsure_begin.weak = bytes.get<double>();
    submap.unsure_begin.weak_height = bytes.get<double>();
    submap.unsure_begin.doubt = bytes.get<double>();
    submap.T_odom_submap = bytes.pose();
    submap.T_map_submap = bytes.pose();
    submap.information = bytes.matrix();
    if (submap.id.value + 1 != submaps.size())
      throw std::runtime_error("its submaps are in no order");
  }
  return submaps;
}

std::string encode(const std::vector<LoopEdge>& loops) {
  ByteWriter bytes;
  for (const LoopEdge& edge : loops) {
    put(edge.loop, bytes);
    put(decisionOf(edge), bytes);
  }
  return bytes.bytes();
}

std::vector<LoopEdge> decodeLoops(const std::string& payload) {
  ByteReader bytes(payload);
  std::vector<LoopEdge> loops;
  while (bytes.left() > 0) {
    LoopEdge edge;
    edge.id.value = static_cast<std::uint32_t>(loops.size());
    edge.loop = getLoop(bytes);
    decide(getDecision(bytes), edge);
    loops.push_back(edge);
  }
  return loops;
}

void requireBetweenSubmaps(const SessionSummary& summary) {
  for (const LoopEdge& edge : summary.loops)
    if (edge.loop.target.value >= summary.submaps.size() ||
        edge.loop.source.value >= summary.submaps.size() || edge.loop.target == edge.loop.source)
      throw std::runtime_error("a loop is not between its submaps");
}

std::string encodeHead(const SessionSummary& summary) {
  ByteWriter bytes;
  bytes.put(summary.start);
  bytes.put(summary.length);
  return bytes.bytes() + summary.name;
}

void decodeHead(const std::string& payload, SessionSummary& summary) {
  ByteReader bytes(payload);
  summary.start = bytes.stamp();
  summary.length = bytes.get<double>();
  summary.name = payload.substr(payload.size() - bytes.left());
}

}  // namespace

SessionSummary summarise(const std::string& folder, const std::string& name,
                         std::vector<std::string>& notices) {
  try {
    const Session session = readSession(folder, notices);
    if (session.submaps.empty()) throw std::runtime_error("it has no closed submap");
    if (session.info.id != SessionId{} || sessionsOf(session).size() > 1)
      throw std::runtime_error("it holds several sessions");
    SessionSummary summary;
    summary.name = name;
    summary.start = session.info.start;
    summary.submaps = submapsOf(session);
    summary.length = summary.submaps.back().travelled_begin;
    summary.loops = session.graph.loops;
    summary.places = placesOf(session, notices);
    return summary;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("the session '" + folder + "' cannot be used: " + error.what());
  }
}

std::string encodeSummary(const SessionSummary& summary) {
  std::string bytes = recordFileHeader(kKind, kVersion) +
                      encodeRecord({kSession, encodeHead(summary)}) +
                      encodeRecord({kSubmaps, encode(summary.submaps)}) +
                      encodeRecord({kLoops, encode(summary.loops)});
  for (const StoredLocalMap& place : summary.places)
    for (const Record& record : recordsOf(place)) bytes += encodeRecord(record);
  return bytes;
}

SessionSummary readSummary(const std::string& path) {
  const RecordFile file = readRecordFile(path, kKind, kVersion);
  if (!file.damage.empty()) throw std::runtime_error(file.damage);
  SessionSummary summary;
  try {
    for (const Record& record : file.records) {
      if (record.type == kSession) decodeHead(record.payload, summary);
      if (record.type == kSubmaps) summary.submaps = decodeSubmaps(record.payload);
      if (record.type == kLoops) summary.loops = decodeLoops(record.payload);
    }
    summary.places = localMapsOf(file.records);
    if (summary.submaps.empty()) throw std::runtime_error("it has no submap");
    requireBetweenSubmaps(summary);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("'" + path + "' cannot be used: " + error.what());
  }
  return summary;
}

}  // namespace revisit_slam
