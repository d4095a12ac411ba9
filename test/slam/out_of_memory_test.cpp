// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "revisit_slam/slam/odometry_stage.h"
#include "support/contains.h"
#include "support/synthetic_drive.h"

namespace {

/// While it lives, one allocation of its thread fails: the one after `allocations` others.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::size_t allocations) {
    failed_ = false;
    left_ = allocations;
  }
  ~FailingAllocation() { left_ = kNone; }
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  bool hasFailed() const { return failed_; }

  /// Null where it is to fail.
  static void* allocate(std::size_t size) {
    if (left_ != kNone && left_-- == 0) {
      left_ = kNone;
      failed_ = true;
      return nullptr;
    }
    return std::malloc(size > 0 ? size : 1);
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static thread_local std::size_t left_;
  static thread_local bool failed_;
};

thread_local std::size_t FailingAllocation::left_ = kNone;
thread_local bool FailingAllocation::failed_ = false;

}  // namespace

// Of the whole program. The other forms of the standard library come down to these.

void* operator new(std::size_t size) {
  if (void* memory = FailingAllocation::allocate(size)) return memory;
  throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return FailingAllocation::allocate(size);
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace revisit_slam {
namespace {

ScanReading readingOf(const Scan& scan) {
  ScanReading reading;
  reading.scan = scan;
  reading.frame_id = "a sensor with a name that is allocated";
  reading.counts.received = scan.points.size();
  return reading;
}

/// What became of a drive.
struct Outcome {
  bool has_failed = false;
  std::vector<OdometryStage::Result> results;
  ScanAccount account;

  Eigen::Vector3d end() const { return results.back().output.scan->T_odom_base.translation; }
};

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// `left_out`: a scan that is never sent; `failing`: one that meets a full memory, after
/// `allocations` that succeeded.
Outcome driveOf(const Drive& drive, std::size_t left_out, std::size_t failing = kNone,
                std::size_t allocations = 0) {
  SlamConfig config;
  config.odometry = roomConfig();
  OdometryStage stage(config);
  Outcome outcome;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    if (i == left_out) continue;
    ScanReading reading = readingOf(drive.scans[i]);
    std::vector<OdometryStage::Result> results;
    if (i == failing) {
      const FailingAllocation failure(allocations);
      results = stage.process(std::move(reading));
      outcome.has_failed = failure.hasFailed();
    } else {
      results = stage.process(std::move(reading));
    }
    for (OdometryStage::Result& result : results) outcome.results.push_back(std::move(result));
  }
  outcome.account = stage.account();
  return outcome;
}

/// Wherever in the odometry the memory is full: the scan is dropped and counted, and the next ones
/// follow as if it had not been sent, or with it, or half of it, in the local map, and without a
/// gap in their numbers.
TEST(OutOfMemory, CostsOneScan) {
  const std::size_t failing = 3;
  const Drive drive = driveInRoom(6);
  const Eigen::Vector3d with = driveOf(drive, kNone).end(), without = driveOf(drive, failing).end();
  EXPECT_GT((with - without).norm(), 0.0);
  int failures = 0;
  for (std::size_t allocations = 0;; allocations += 1 + allocations / 12) {
    SCOPED_TRACE("after " + std::to_string(allocations) + " allocations");
    const Outcome outcome = driveOf(drive, kNone, failing, allocations);
    const ScanAccount& account = outcome.account;
    EXPECT_EQ(account.received, drive.scans.size());
    EXPECT_EQ(account.processed + account.droppedInAll(), account.received);
    std::uint32_t next = 0;
    for (const OdometryStage::Result& result : outcome.results) {
      if (result.output.scan)
        EXPECT_EQ(result.output.scan->id.value, next++);
      else
        EXPECT_TRUE(contains(result.rejection, "error: ")) << result.rejection;
    }
    EXPECT_EQ(next, account.processed);
    ASSERT_TRUE(outcome.results.back().output.scan);
    const Eigen::Vector3d end = outcome.end();
    EXPECT_LT(std::min((end - with).norm(), (end - without).norm()), 0.01);
    if (!outcome.has_failed) break;
    EXPECT_GE(account.processed, drive.scans.size() - 1);
    ++failures;
  }
  EXPECT_GT(failures, 30);
}

}  // namespace
}  // namespace revisit_slam
