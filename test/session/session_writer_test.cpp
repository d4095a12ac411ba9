// SPDX-License-Identifier: MIT
#include "revisit_slam/session/session_writer.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "session/session_fixtures.h"
#include "support/contains.h"
#include "support/failing_sync.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

void add(SessionWriter& writer, std::size_t submap) {
  const StreetDrive& drive = StreetDrive::get();
  const MapUpdatePtr& update = drive.updates.at(submap);
  writer.add(drive.nodesOf(*update->submap), closedOf(*update->submap, update->detail_submap),
             update);
}

Session readQuietly(const std::string& folder) {
  std::vector<std::string> notices;
  return readSession(folder, notices);
}

TEST(SessionWriter, WhatCannotBeWrittenWaitsUntilItCan) {
  const TemporaryFolder folder;
  const std::string path = folder.with("taken", "a file where the folder is to be");
  SessionWriter writer({path, "", nullptr, false}, someInfo(), 0);
  add(writer, 0);
  writer.drain();
  EXPECT_TRUE(contains(writer.problem(), path));
  EXPECT_EQ(writer.unwritten().size(), 1u);
  std::filesystem::remove(path);
  add(writer, 1);
  writer.drain();
  EXPECT_EQ(writer.problem(), "");
  EXPECT_TRUE(writer.unwritten().empty());
  EXPECT_EQ(readQuietly(path).submaps.size(), 2u);
}

TEST(SessionWriter, ASubmapIsInTheLogWhenItsFileIsWhole) {
  const TemporaryFolder folder;
  const std::string path = folder.file("session");
  SessionWriter writer({path, "", nullptr, false}, someInfo(), 0);
  writer.drain();
  std::filesystem::create_directories(submapFile(path, SubmapId{0}) + ".part/in the way");
  add(writer, 0);
  writer.drain();
  EXPECT_NE(writer.problem(), "");
  EXPECT_TRUE(readQuietly(path).submaps.empty());
  std::filesystem::remove_all(submapFile(path, SubmapId{0}) + ".part");
  writer.drain();
  EXPECT_EQ(readQuietly(path).submaps.size(), 1u);
}

TEST(SessionWriter, ADiskWithAFaultAtTheFirstSubmapCostsNothing) {
  const TemporaryFolder folder;
  const std::string path = folder.file("session");
  SessionWriter writer({path, "", nullptr, false}, someInfo(), 0);
  writer.drain();
  {
    const FailingSync fault;
    add(writer, 0);
    writer.drain();
    EXPECT_TRUE(contains(writer.problem(), strerror(EIO))) << writer.problem();
  }
  writer.drain();
  EXPECT_EQ(writer.problem(), "");
  EXPECT_EQ(readQuietly(path).submaps.size(), 1u);
}

/// The file of the first submap is a pipe that takes little, and that nobody reads at first.
TEST(SessionWriter, TellsHowLongASlowDiskLetsItWait) {
  const TemporaryFolder folder;
  const std::string path = folder.file("session");
  SessionWriter writer({path, "", nullptr, false}, someInfo(), 0);
  writer.drain();
  EXPECT_EQ(writer.backlog().writes, 0u);
  EXPECT_EQ(writer.backlog().seconds, 0.0);
  const std::string name = submapFile(path, SubmapId{0}) + ".part";
  ASSERT_EQ(mkfifo(name.c_str(), 0600), 0);
  const int pipe = open(name.c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_GE(pipe, 0);
  add(writer, 0);
  add(writer, 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(writer.backlog().writes, 2u);
  EXPECT_GE(writer.backlog().seconds, 0.1);
  EXPECT_EQ(writer.problem(), "");
  std::atomic<bool> is_done{false};
  std::thread reader([&] {
    std::array<char, 65536> bytes{};
    while (!is_done)
      if (read(pipe, bytes.data(), bytes.size()) < 0) std::this_thread::yield();
  });
  writer.drain();  // a pipe cannot be handed to a disk: what is tried again makes a file
  is_done = true;
  reader.join();
  close(pipe);
  EXPECT_EQ(writer.backlog().writes, 0u);
  EXPECT_EQ(readQuietly(path).submaps.size(), 2u);
}

TEST(SessionWriter, AFolderWithResultsOrInUseIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("session");
  writeStreetSession(path);
  SessionWriter writer({path, "", nullptr, false}, someInfo(), 0);
  add(writer, 0);
  writer.drain();
  EXPECT_TRUE(contains(writer.problem(), "not overwritten"));
  EXPECT_EQ(readQuietly(path).submaps.size(), StreetDrive::get().updates.size());
}

/// The log of the drive is written beside the session, by somebody else.
TEST(SessionWriter, AFolderThatIsOursMayHoldWhatIsWrittenBeside) {
  const TemporaryFolder folder;
  const std::string path = folder.file("session");
  std::filesystem::create_directories(path);
  folder.with("session/odometry.tum", "");
  SessionTarget target{path, "", nullptr, false};
  target.is_ours = true;
  SessionWriter writer(target, someInfo(), 0);
  add(writer, 0);
  writer.drain();
  EXPECT_EQ(writer.problem(), "");
  EXPECT_EQ(readQuietly(path).submaps.size(), 1u);
}

TEST(SessionWriter, NoticesThatItsFolderWasRemoved) {
  const TemporaryFolder folder;
  const std::string path = folder.file("session");
  SessionWriter writer({path, "", nullptr, false}, someInfo(), 0);
  add(writer, 0);
  writer.drain();
  EXPECT_FALSE(writer.lost());
  std::filesystem::remove_all(path);
  add(writer, 1);
  writer.drain();
  EXPECT_TRUE(writer.lost());
  EXPECT_NE(writer.problem(), "");
}

/// Searches for loops take as long as the machine needs, while the drive goes on.
TEST(SessionWriter, TheLogsAreTheSameWhereverInTheDriveTheGraphAnswers) {
  const TemporaryFolder folder;
  GraphOptimised optimised;
  optimised.version = 1;
  const Submap& source = *StreetDrive::get().updates.at(1)->submap;
  optimised.last_scan = source.lastScan();
  optimised.constraints = {someLoop()};
  optimised.constraints.front().source = source.id;
  optimised.constraints.front().constraint.to = source.first_scan;
  optimised.decisions.resize(1);
  const auto written = [&](const char* name, std::size_t submaps_before) {
    SessionWriter writer({folder.file(name), "", nullptr, false}, someInfo(), 0);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == submaps_before) writer.add(LogEntry(optimised));
      add(writer, i);
    }
    if (submaps_before == 3) writer.add(LogEntry(optimised));
    writer.close();
  };
  written("at_once", 2);
  written("late", 3);
  for (const char* log : {"/graph.log", "/optimisations.log"})
    EXPECT_EQ(textOf(folder.file("at_once") + log), textOf(folder.file("late") + log)) << log;
  EXPECT_EQ(readQuietly(folder.file("late")).graph.loops.size(), 1u);
}

TEST(SessionWriter, ASessionThatGoesOnIsOpenAgain) {
  const TemporaryFolder folder;
  const std::string path = folder.file("session");
  SessionWriter writer({path, "", nullptr, false}, someInfo(), 0);
  add(writer, 0);
  writer.close();
  writer.drain();
  EXPECT_TRUE(readQuietly(path).info.closed);
  add(writer, 1);
  writer.drain();
  EXPECT_FALSE(readQuietly(path).info.closed);
}

}  // namespace
}  // namespace revisit_slam
