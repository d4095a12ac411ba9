// SPDX-License-Identifier: MIT
// The first byte chooses a file of a session, and whether the others are its bytes or records that
// get checksums: a length of two bytes, a type, contents. All files beside it are good.
#include <algorithm>

#include "readers.h"
#include "revisit_slam/io/record_file.h"
#include "revisit_slam/session/known_map.h"
#include "revisit_slam/session/map_export.h"
#include "revisit_slam/session/stored_local_map.h"
#include "revisit_slam/session/stored_submap.h"
#include "scratch.h"

namespace revisit_slam::fuzz {
namespace {

struct Kind {
  const char* file;
  const char* begins = "";  // a file of records; empty: of bytes
  std::uint32_t version = 1;
  const char* seed = file;  // of the good session
};
const Kind kKinds[] = {{"session.yaml"},
                       {"graph.log"},
                       {"graph.log", "RSGRAPH\n"},
                       {"submaps/000000.rsm"},
                       {"submaps/000000.rsm", "RSSUBMAP"},
                       {"local_maps/0000.rsm"},
                       {"local_maps/0000.rsm", "RSLOCMAP"},
                       {"optimisations.log", "", 1, "graph.log"},
                       {"optimisations.log", "RSGRAPH\n", 1, "graph.log"},
                       {"submaps/000000.rsm", "RSSUBMAP", 2},
                       {"submaps/000001.rsm", "RSSUBMAP", 2}};  // away from the origin

constexpr const char* kGood = REVISIT_SLAM_SOURCE_FOLDER "/test/session/format_1";

std::string fileOfRecords(const Kind& kind, const std::string& bytes) {
  std::string file = recordFileHeader(kind.begins, kind.version);
  for (std::size_t i = 0; i + 3 <= bytes.size();) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[i + k]); };
    const std::size_t length = byte(0) + 256u * byte(1);
    file += encodeRecord({byte(2), bytes.substr(i + 3, length)});
    i += 3 + length;
  }
  return file;
}

/// Of a map of many kilometres the grid may take what its cells take: that is no finding.
bool isSmall(const Session& session) {
  return std::all_of(session.graph.T_map_scan.begin(), session.graph.T_map_scan.end(),
                     [](const Pose& T) { return (T.translation.array().abs() < 500.0).all(); });
}

std::string bytesOf(const Record& record) {
  std::string bytes;
  bytes += static_cast<char>(record.payload.size() % 256);
  bytes += static_cast<char>(record.payload.size() / 256);
  return bytes + static_cast<char>(record.type) + record.payload;
}

std::string recordsOf(const std::string& path, const Kind& kind) {
  std::string bytes;
  for (const Record& record : readRecordFile(path, kind.begins, 1).records)
    bytes += bytesOf(record);
  if (kind.version == 1) return bytes;
  // What the good session is too old for: when points were seen, and how bright they were.
  bytes += bytesOf({static_cast<std::uint32_t>(SubmapRecord::sightings), std::string(4, '\0')});
  return bytes + bytesOf({static_cast<std::uint32_t>(SubmapRecord::intensities), ""});
}

}  // namespace

void readSessionFiles(const std::string& bytes) {
  if (bytes.empty()) return;
  const Kind& kind = kKinds[static_cast<unsigned char>(bytes[0]) % std::size(kKinds)];
  static const Scratch scratch;
  const std::string folder = scratch.file("session");
  std::filesystem::remove_all(folder);
  std::filesystem::copy(kGood, folder, std::filesystem::copy_options::recursive);
  const std::string begins = kind.begins, rest = bytes.substr(1);
  scratch.with(std::string("session/") + kind.file,
               begins.empty() ? rest : fileOfRecords(kind, rest));
  const bool of_local_map = std::string(kind.file).rfind("local_maps", 0) == 0;
  if (of_local_map) readLocalMap(localMapFile(folder, LocalMapId{0}));
  if (of_local_map) return;
  std::vector<std::string> notices;
  const Session session = readSession(folder, notices);
  readSubmap(submapFile(folder, SubmapId{0}),
             {SubmapRecord::trajectory, SubmapRecord::points, SubmapRecord::normals});
  readKnownMap(folder, {}, {}, notices);
  ExportConfig config;
  config.remove_dynamic = true;
  config.occupancy = isSmall(session);
  exportSession(session, scratch.file("out"), config);
}

Seeds seedsOfSession() {
  Seeds seeds;
  for (const Kind& kind : kKinds) {
    const std::string path = std::string(kGood) + "/" + kind.seed, begins = kind.begins;
    seeds.push_back(std::string(1, static_cast<char>(seeds.size())) +
                    (begins.empty() ? bytesOfFile(path) : recordsOf(path, kind)));
  }
  return seeds;
}

}  // namespace revisit_slam::fuzz
