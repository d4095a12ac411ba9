// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace revisit_slam {

/// A piece of a file with a checksum of its own. Numbers are little-endian:
///
///   u32 type, u32 length of the payload in bytes, payload, u32 CRC-32 of all these (as in zlib).
struct Record {
  std::uint32_t type = 0;
  std::string payload;
};

std::string encodeRecord(const Record& record);

/// What a file of records begins with: eight letters that name its kind, u32 version of the format.
std::string recordFileHeader(const std::string& kind, std::uint32_t version);

/// What could be read of a file of records.
struct RecordFile {
  std::vector<Record> records;    ///< the whole ones, up to the first that is not
  std::uint64_t whole_bytes = 0;  ///< up to the end of the last whole record
  std::string damage;             ///< empty, or why there is nothing of what follows
};

/// Reads records up to the first that is cut or damaged; of those of other types than the wanted
/// ones (none named: all) the length alone.
/// @throws std::runtime_error naming a file that cannot be opened, is of another kind, or of a
/// newer version.
RecordFile readRecordFile(const std::string& path, const std::string& kind, std::uint32_t version,
                          const std::set<std::uint32_t>& wanted = {});

}  // namespace revisit_slam
