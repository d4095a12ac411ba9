// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_crossing.h"

#include <stdexcept>

#include "loop_bytes.h"
#include "revisit_slam/io/record_file.h"

namespace revisit_slam {
namespace {

constexpr char kKind[] = "RSCROSS\n";
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kSource = 1, kTarget = 2, kLoops = 3, kOutcome = 4;

}  // namespace

std::string encodeCrossing(const SessionCrossing& crossing) {
  ByteWriter loops;
  for (const LoopConstraint& loop : crossing.loops) put(loop, loops);
  std::string bytes = recordFileHeader(kKind, kVersion) + encodeRecord({kSource, crossing.source}) +
                      encodeRecord({kTarget, crossing.target}) +
                      encodeRecord({kLoops, loops.bytes()});
  for (const auto& [outcome, count] : crossing.outcomes) {
    ByteWriter number;
    number.put(static_cast<std::uint32_t>(count));
    bytes += encodeRecord({kOutcome, number.bytes() + outcome});
  }
  return bytes;
}

SessionCrossing readCrossing(const std::string& path) {
  const RecordFile file = readRecordFile(path, kKind, kVersion);
  if (!file.damage.empty()) throw std::runtime_error(file.damage);
  SessionCrossing crossing;
  for (const Record& record : file.records) {
    ByteReader bytes(record.payload);
    if (record.type == kSource) crossing.source = record.payload;
    if (record.type == kTarget) crossing.target = record.payload;
    if (record.type == kLoops)
      while (bytes.left() > 0) crossing.loops.push_back(getLoop(bytes));
    if (record.type == kOutcome) {
      const auto count = bytes.get<std::uint32_t>();
      crossing.outcomes[record.payload.substr(sizeof(count))] = count;
    }
  }
  return crossing;
}

}  // namespace revisit_slam
