// SPDX-License-Identifier: MIT
#include "revisit_slam/io/record_file.h"

#include <gtest/gtest.h>

#include "support/contains.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

constexpr char kKind[] = "RSSOMEKD";

std::string threeRecords() {
  return recordFileHeader(kKind, 1) + encodeRecord({1, "first"}) + encodeRecord({2, ""}) +
         encodeRecord({1, "the third"});
}

RecordFile read(const std::string& bytes, const std::set<std::uint32_t>& wanted = {}) {
  const TemporaryFolder folder;
  return readRecordFile(folder.with("file", bytes), kKind, 1, wanted);
}

TEST(RecordFile, WhatIsWrittenIsRead) {
  const RecordFile file = read(threeRecords());
  ASSERT_EQ(file.records.size(), 3u);
  EXPECT_EQ(file.records[0].payload, "first");
  EXPECT_EQ(file.records[1].type, 2u);
  EXPECT_EQ(file.records[2].payload, "the third");
  EXPECT_EQ(file.damage, "");
  EXPECT_EQ(file.whole_bytes, threeRecords().size());
  EXPECT_EQ(read(threeRecords(), {2}).records.size(), 1u);
}

TEST(RecordFile, ARecordIsWhatTheDocumentationSays) {
  // The checksum is that of Python's zlib.crc32(b"\x07\0\0\0\x02\0\0\0hi").
  EXPECT_EQ(encodeRecord({7, "hi"}), std::string("\x07\0\0\0\x02\0\0\0hi\x57\xea\xd4\xd5", 14));
}

TEST(RecordFile, CutAnywhereItGivesTheRecordsBefore) {
  const std::string whole = threeRecords();
  const std::size_t header = recordFileHeader(kKind, 1).size();
  const std::size_t first = header + encodeRecord({1, "first"}).size();
  const std::size_t second = first + encodeRecord({2, ""}).size();
  for (std::size_t size = header; size < whole.size(); ++size) {
    const RecordFile file = read(whole.substr(0, size));
    EXPECT_EQ(file.records.size(), size < first ? 0u : size < second ? 1u : 2u) << size;
    EXPECT_EQ(file.damage.empty(), size == header || size == first || size == second) << size;
  }
  EXPECT_THROW(read(whole.substr(0, header - 1)), std::runtime_error);
}

TEST(RecordFile, ABitThatFlipsIsFound) {
  const std::string whole = threeRecords();
  const std::size_t header = recordFileHeader(kKind, 1).size();
  for (std::size_t i = header; i < whole.size(); ++i) {
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 4);
    const RecordFile file = read(flipped);
    EXPECT_LT(file.records.size(), 3u) << i;
    EXPECT_NE(file.damage, "") << i;
  }
}

TEST(RecordFile, FilesOfOtherKindsAndNewerVersionsAreRefused) {
  EXPECT_THROW(read("RSOTHER!" + threeRecords().substr(8)), std::runtime_error);
  try {
    read(recordFileHeader(kKind, 2));
    FAIL() << "read a newer version";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), "format 2")) << error.what();
  }
}

}  // namespace
}  // namespace revisit_slam
