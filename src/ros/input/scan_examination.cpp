// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/scan_examination.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "revisit_slam/slam/drop_remedies.h"
#include "revisit_slam/util/quantile.h"

namespace revisit_slam {
namespace {

using Level = Finding::Level;

/// What is usual of scans that can be registered.
constexpr double kFewPoints = 1000.0;
constexpr double kSmallShare = 0.3;      // of points that are measurements
constexpr double kAnotherClock = 1.0;    // s between stamp and arrival
constexpr double kLongestRange = 500.0;  // m that LiDARs see
constexpr double kLongPause = 5.0;       // periods
constexpr double kSlowest = 4.0;         // Hz

std::string number(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

/// Between one and the next.
std::vector<double> stepsOf(const std::vector<double>& instants) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < instants.size(); ++i) steps.push_back(instants[i] - instants[i - 1]);
  return steps;
}

}  // namespace

ScanExamination::ScanExamination(const SlamConfig& config)
    : odometry_(config.odometry),
      reader_(config.input),
      assembler_(config.input),
      gate_(config.odometry.max_prediction_time, config.odometry.restart_after) {}

void ScanExamination::add(const RawMessage& message) {
  ++account_.received;
  arrivals_.push_back(message.arrival.toSeconds());
  ScanReading reading = reader_.read(message);
  if (frame_.empty()) frame_ = reading.frame_id;
  if (reading.header_stamp.nanoseconds != 0)
    lateness_.push_back(secondsBetween(reading.header_stamp, message.arrival));
  if (!reading.scan) {
    ++account_.dropped[describe(reading.rejection)];
    return;
  }
  measure(reading);
  take(assembler_.take(std::move(reading)));
}

void ScanExamination::measure(const ScanReading& reading) {
  constexpr std::size_t samples = 200;
  const PointCounts& counts = reading.counts;
  counts_.push_back(static_cast<double>(counts.kept));
  used_shares_.push_back(static_cast<double>(counts.kept) / static_cast<double>(counts.received));
  const Points& points = reading.scan->points;
  const std::size_t step = std::max<std::size_t>(1, points.size() / samples);
  for (std::size_t i = 0; i < points.size(); i += step)
    ranges_.push_back(static_cast<double>(points[i].norm()));
}

void ScanExamination::take(std::vector<SweepAssembler::Sweep> sweeps) {
  for (SweepAssembler::Sweep& sweep : sweeps) {
    account_.joined += sweep.messages - 1;
    if (sweep.refusal.empty())
      take(gate_.take(std::move(sweep.reading)));
    else
      ++account_.dropped[sweep.refusal];
  }
}

void ScanExamination::take(const std::vector<StampGate::Decision>& decisions) {
  for (const StampGate::Decision& decision : decisions) {
    if (decision.refusal.empty())
      ++account_.processed;
    else
      ++account_.dropped[decision.refusal];
  }
}

std::vector<Finding> ScanExamination::findings() {
  take(assembler_.flush());
  take(gate_.flush());
  std::vector<Finding> findings{aboutDrops()};
  if (account_.received > 1) findings.push_back(aboutRate());
  if (!lateness_.empty()) findings.push_back(aboutStamps());
  if (!counts_.empty())
    for (const Finding& finding : {aboutTimes(), aboutPoints(), aboutRanges()})
      findings.push_back(finding);
  return findings;
}

Finding ScanExamination::aboutDrops() const {
  const std::string drops = describeDrops(account_);
  if (drops.empty())
    return {Level::good, "messages",
            std::to_string(account_.received) + " looked at, all can be used" +
                (account_.joined > 0 ? "; " + assembler_.description() : ""),
            ""};
  const std::size_t split = drops.find(": ");
  return {account_.processed == 0 ? Level::fault : Level::warning, "messages",
          drops.substr(0, split), split == std::string::npos ? "" : drops.substr(split + 2)};
}

Finding ScanExamination::aboutRate() const {
  const std::vector<double> steps = stepsOf(arrivals_);
  const double period = quantile(steps, 0.5), longest = quantile(steps, 1.0);
  const double seconds = arrivals_.back() - arrivals_.front();
  const double rate = seconds > 0.0 ? static_cast<double>(steps.size()) / seconds : 0.0;
  Finding finding{Level::good, "rate", number("%.1f messages/s", rate), ""};
  if (longest > kLongPause * period && longest > 0.5) {
    finding.level = Level::warning;
    finding.text += number(", but the longest pause is %.1f s", longest);
    finding.remedy =
        "messages are lost on their way: record with a larger buffer (rosbag record -b 0), or run "
        "driver and revisit_slam in one nodelet manager";
  } else if (rate > 0.0 && rate < kSlowest) {
    finding.level = Level::warning;
    finding.remedy = "let the sensor turn faster (10 Hz), or move slowly";
  }
  return finding;
}

Finding ScanExamination::aboutStamps() const {
  const double late = quantile(lateness_, 0.5);
  if (std::abs(late) <= kAnotherClock)
    return {Level::good, "header stamps", number("%.0f ms before arrival", 1e3 * late), ""};
  return {Level::warning, "header stamps",
          number("%.1f s ", std::abs(late)) + (late > 0.0 ? "before" : "after") +
              " arrival: the sensor has another clock than the robot",
          "synchronise the sensor (PTP, or the driver's time stamp option); where transforms or "
          "other sensors are used without that, set input/stamps to arrival"};
}

Finding ScanExamination::aboutTimes() const {
  const std::string remedy = reader_.remedy();
  if (!remedy.empty()) return {Level::warning, "point times", reader_.description(), remedy};
  if (assembler_.doubtsTimes())
    return {Level::warning, "point times", assembler_.description(),
            "set input/time_unit or input/time_field"};
  return {Level::good, "point times", reader_.description(), ""};
}

Finding ScanExamination::aboutPoints() const {
  const double count = quantile(counts_, 0.5), share = quantile(used_shares_, 0.5);
  Finding finding{Level::good, "points",
                  number("%.0f a message that are measurements", count) +
                      number(", %.0f of 100 sent", 100.0 * share),
                  ""};
  const double a_scan = count * static_cast<double>(account_.received) /
                        static_cast<double>(std::max<std::size_t>(1, account_.processed));
  if (a_scan < kFewPoints) {
    finding.level = Level::warning;
    finding.remedy = "few points to register: does the driver thin them out? Use its full cloud";
  } else if (share < kSmallShare) {
    finding.level = Level::hint;
    finding.remedy =
        "most points are NaN or at the origin, as in the open: nothing to do unless "
        "the sensor is covered";
  }
  return finding;
}

Finding ScanExamination::aboutRanges() const {
  const double far = quantile(ranges_, 0.99);
  Finding finding{Level::good, "ranges",
                  number("median %.1f m", quantile(ranges_, 0.5)) +
                      number(", 99 of 100 points within %.1f m", far),
                  ""};
  const auto is_in_range = [&](double range) {
    return odometry_.min_range <= range && range <= odometry_.max_range;
  };
  const auto in_range = std::count_if(ranges_.begin(), ranges_.end(), is_in_range);
  if (far > kLongestRange) {
    finding.level = Level::fault;
    finding.remedy = "no LiDAR sees so far: the coordinates must be in metres";
  } else if (in_range == 0) {
    finding.level = Level::fault;
    finding.remedy = "no point is between odometry/min_range and odometry/max_range: set these";
  }
  return finding;
}

}  // namespace revisit_slam
