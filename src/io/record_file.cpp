// SPDX-License-Identifier: MIT
#include "revisit_slam/io/record_file.h"

#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "revisit_slam/io/bytes.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kKindLength = 8;
constexpr std::size_t kHeadLength = 2 * sizeof(std::uint32_t);  // of a record

std::uint32_t checksumOf(const char* head, const std::string& payload) {
  const auto add = [](uLong crc, const char* data, std::size_t size) {
    return crc32(crc, reinterpret_cast<const Bytef*>(data), static_cast<uInt>(size));
  };
  return static_cast<std::uint32_t>(add(add(0, head, kHeadLength), payload.data(), payload.size()));
}

std::string headOf(const Record& record) {
  ByteWriter head;
  head.put(record.type);
  head.put(static_cast<std::uint32_t>(record.payload.size()));
  return head.bytes();
}

/// Goes through a file record by record.
class RecordReading {
 public:
  RecordReading(const std::string& path, const std::string& kind, std::uint32_t version)
      : path_(path), file_(path, std::ios::binary) {
    if (!file_) throw std::runtime_error("cannot read '" + path + "': " + std::strerror(errno));
    file_.seekg(0, std::ios::end);
    size_ = static_cast<std::uint64_t>(file_.tellg());
    file_.seekg(0);
    const std::string header = take(kKindLength + sizeof(std::uint32_t));
    if (header.substr(0, kKindLength) != kind)
      throw std::runtime_error("'" + path + "' does not begin as a file of this kind does");
    const std::string number = header.substr(kKindLength);
    const auto found = ByteReader(number).get<std::uint32_t>();
    if (found > version)
      throw std::runtime_error("'" + path + "' has format " + std::to_string(found) +
                               ", this software knows formats up to " + std::to_string(version));
  }

  RecordFile read(const std::set<std::uint32_t>& wanted) {
    RecordFile result;
    for (result.whole_bytes = position(); result.whole_bytes < size_;
         result.whole_bytes = position()) {
      result.damage = readOne(wanted, result.records);
      if (!result.damage.empty()) {
        result.damage = path_ + ": " + result.damage + "; " +
                        std::to_string(size_ - result.whole_bytes) +
                        " bytes at its end are left out";
        break;
      }
    }
    return result;
  }

 private:
  /// Returns what is wrong.
  std::string readOne(const std::set<std::uint32_t>& wanted, std::vector<Record>& records) {
    const std::uint64_t begin = position();
    if (size_ - begin < kHeadLength) return "the last record is cut";
    const std::string head = take(kHeadLength);
    ByteReader numbers(head);
    Record record{numbers.get<std::uint32_t>(), {}};
    const auto length = numbers.get<std::uint32_t>();
    if (size_ - position() < length + sizeof(std::uint32_t))
      return "the record at byte " + std::to_string(begin) + " is cut";
    if (!wanted.empty() && wanted.count(record.type) == 0) {
      file_.seekg(length + sizeof(std::uint32_t), std::ios::cur);
      return "";
    }
    record.payload = take(length);
    const std::string checksum = take(sizeof(std::uint32_t));
    if (ByteReader(checksum).get<std::uint32_t>() != checksumOf(head.data(), record.payload))
      return "the record at byte " + std::to_string(begin) + " is damaged (checksum)";
    records.push_back(std::move(record));
    return "";
  }

  std::uint64_t position() { return static_cast<std::uint64_t>(file_.tellg()); }

  std::string take(std::size_t size) {
    std::string bytes(size, '\0');
    if (!file_.read(bytes.data(), static_cast<std::streamsize>(size)))
      throw std::runtime_error("'" + path_ + "' is cut within its first bytes, or cannot be read");
    return bytes;
  }

  std::string path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
};

}  // namespace

std::string encodeRecord(const Record& record) {
  const std::string head = headOf(record);
  ByteWriter checksum;
  checksum.put(checksumOf(head.data(), record.payload));
  return head + record.payload + checksum.bytes();
}

std::string recordFileHeader(const std::string& kind, std::uint32_t version) {
  ByteWriter number;
  number.put(version);
  return kind + number.bytes();
}

RecordFile readRecordFile(const std::string& path, const std::string& kind, std::uint32_t version,
                          const std::set<std::uint32_t>& wanted) {
  return RecordReading(path, kind, version).read(wanted);
}

}  // namespace revisit_slam
