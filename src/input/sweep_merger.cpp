// SPDX-License-Identifier: MIT
#include "revisit_slam/input/sweep_merger.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "revisit_slam/util/number_list.h"

namespace revisit_slam {
namespace {

constexpr double kDefaultPeriod = 0.1;     // s
constexpr double kShortestPeriod = 0.001;  // s: no sensor turns faster
/// s: clocks that count from the start of the sensor are as far apart.
constexpr double kLargestOffset = 4e9;
constexpr std::int64_t kLeap = 1'000'000'000;  // ns: a stamp so far off has to be confirmed
/// Of the first window a sweep that begins behind this share of it is a rest.
constexpr double kLatestBegin = 0.5;
/// Of the points of the sweep before: fewer at the end are a rest, too.
constexpr double kSmallestRest = 0.25;

std::int64_t nanosecondsOf(double seconds) {
  return std::llround(1e9 * seconds);
}

}  // namespace

SweepMerger::SweepMerger(const ScanInputConfig& config)
    : length_(nanosecondsOf(config.scan_period > 0.0 ? config.scan_period : kDefaultPeriod)),
      max_wait_(nanosecondsOf(config.max_wait)) {
  if (config.scan_period > 0.0 && config.scan_period < kShortestPeriod)
    throw ParameterError("input/scan_period is " + std::to_string(config.scan_period) +
                         ", but sweeps take 0.001 to 2 s; 0: as the messages say");
  const std::vector<std::string> topics = wordsOf(config.topics);
  const std::vector<double> ranges =
      numbersOf(config.ranges, 2 * topics.size(), "input/ranges",
                "a shortest and a longest range (m) for each of input/topics, or empty");
  const std::vector<double> offsets =
      numbersOf(config.time_offsets, topics.size(), "input/time_offsets",
                "a time (s) for each of input/topics, or empty");
  for (std::size_t i = 0; i < topics.size(); ++i) {
    Sensor& sensor = sensors_.emplace_back();
    sensor.topic = topics[i];
    if (!offsets.empty()) sensor.time_offset = offsets[i];
    if (std::abs(sensor.time_offset) > kLargestOffset)
      throw ParameterError("input/time_offsets has " + std::to_string(sensor.time_offset) +
                           " s, but may have -4e9 to 4e9 s");
    if (ranges.empty()) continue;
    sensor.nearest = static_cast<float>(ranges[2 * i] * ranges[2 * i]);
    sensor.farthest = static_cast<float>(ranges[2 * i + 1] * ranges[2 * i + 1]);
  }
}

std::vector<ScanReading> SweepMerger::take(ScanReading reading) {
  std::vector<ScanReading> sweeps;
  Sensor& sensor = sensors_.at(reading.sensor);
  ++sensor.account.messages;
  reading.scan->stamp = reading.scan->stamp.plusSeconds(sensor.time_offset);
  const Stamp stamp = reading.scan->stamp;
  if (sensor.ahead) {
    ScanReading held = std::move(*std::exchange(sensor.ahead, std::nullopt));
    if (held.scan->stamp <= stamp)
      accept(std::move(held), sweeps);
    else
      sensor.account.points_dropped["stamp ahead of the next one"] += held.scan->points.size();
  }
  if (isLeap(sensor, stamp))
    sensor.ahead = std::move(reading);
  else
    accept(std::move(reading), sweeps);
  return sweeps;
}

/// Far ahead of what this sensor and all others have reached.
bool SweepMerger::isLeap(const Sensor& sensor, Stamp stamp) const {
  return sensor.reached && stamp.nanoseconds > newest() + kLeap;
}

void SweepMerger::accept(ScanReading reading, std::vector<ScanReading>& sweeps) {
  Sensor& sensor = sensors_[reading.sensor];
  const Scan& scan = *reading.scan;
  const bool went_back = sensor.reached && scan.stamp < *sensor.reached && closed_until_ &&
                         scan.stamp.nanoseconds < *closed_until_ * length_ - kLeap - max_wait_;
  if (went_back) {  // the clock: what follows is another session, which the stamp gate tells
    for (ScanReading& sweep : flush()) sweeps.push_back(std::move(sweep));
    for (Sensor& any : sensors_) any.reached.reset();
    closed_until_.reset();
  }
  has_intensities_ = has_intensities_ || !scan.intensities.empty();
  sensor.T_base_sensor = scan.T_base_sensor;
  sensor.frame_id = reading.frame_id;
  if (!sensor.reached || *sensor.reached < scan.stamp) sensor.reached = scan.stamp;
  if (scan.stamp.nanoseconds >= newest()) sensor.account.is_silent = false;
  if (closed_until_ && scan.stamp.nanoseconds >= *closed_until_ * length_)
    sensor.account.is_silent = false;
  store(scan, sensor);
  close(sweeps);
}

void SweepMerger::store(const Scan& scan, Sensor& sensor) const {
  const std::int64_t too_late =
      closed_until_ ? *closed_until_ * length_ : std::numeric_limits<std::int64_t>::min();
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const double before = scan.times.empty() ? 0.0 : static_cast<double>(scan.times[i]);
    const float intensity = scan.intensities.empty() ? 0.0f : scan.intensities[i];
    const Point point{scan.stamp.nanoseconds + nanosecondsOf(before), scan.points[i], intensity};
    const float range = point.p_sensor.squaredNorm();
    if (range < sensor.nearest)
      ++sensor.account.points_dropped["too near"];
    else if (range > sensor.farthest)
      ++sensor.account.points_dropped["too far"];
    else if (point.nanoseconds < too_late)
      ++sensor.account.points_dropped["too late"];
    else
      sensor.points.push_back(point);
  }
}

std::int64_t SweepMerger::newest() const {
  std::int64_t newest = std::numeric_limits<std::int64_t>::min();
  for (const Sensor& sensor : sensors_)
    if (sensor.reached) newest = std::max(newest, sensor.reached->nanoseconds);
  return newest;
}

bool SweepMerger::allReach(std::int64_t end) const {
  return std::all_of(sensors_.begin(), sensors_.end(), [&](const Sensor& sensor) {
    return sensor.account.is_silent || (sensor.reached && sensor.reached->nanoseconds >= end);
  });
}

/// Of those that have points.
std::optional<std::int64_t> SweepMerger::oldestWindow() const {
  std::int64_t oldest = std::numeric_limits<std::int64_t>::max();
  for (const Sensor& sensor : sensors_)
    for (const Point& point : sensor.points) oldest = std::min(oldest, point.nanoseconds);
  if (oldest == std::numeric_limits<std::int64_t>::max()) return std::nullopt;
  return oldest / length_;
}

void SweepMerger::close(std::vector<ScanReading>& sweeps) {
  while (const std::optional<std::int64_t> window = oldestWindow()) {
    const std::int64_t end = (*window + 1) * length_;
    const bool waited = newest() >= end + max_wait_;
    if (!allReach(end) && !waited) return;
    if (waited)
      for (Sensor& sensor : sensors_)
        if (!sensor.reached || sensor.reached->nanoseconds < end) sensor.account.is_silent = true;
    if (std::optional<ScanReading> sweep = closeWindow(*window))
      sweeps.push_back(std::move(*sweep));
  }
}

std::vector<ScanReading> SweepMerger::flush() {
  std::vector<ScanReading> sweeps;
  for (Sensor& sensor : sensors_) {
    if (!sensor.ahead) continue;
    const ScanReading held = std::move(*std::exchange(sensor.ahead, std::nullopt));
    store(*held.scan, sensor);
  }
  while (const std::optional<std::int64_t> window = oldestWindow()) {
    const auto usual = static_cast<double>(last_size_);
    if (std::optional<ScanReading> sweep = closeWindow(*window, kSmallestRest * usual))
      sweeps.push_back(std::move(*sweep));
  }
  return sweeps;
}

/// Takes its points out, in the order of the sensors.
std::optional<ScanReading> SweepMerger::closeWindow(std::int64_t window, double fewest) {
  const bool is_first = !closed_until_;
  closed_until_ = window + 1;
  const std::int64_t end = *closed_until_ * length_;
  ScanReading reading;
  Scan& scan = reading.scan.emplace();
  std::vector<std::int64_t> times;
  std::vector<std::pair<SensorAccount*, std::size_t>> points;
  for (Sensor& sensor : sensors_) {
    const auto is_later = [&](const Point& point) { return point.nanoseconds >= end; };
    const auto later = std::stable_partition(sensor.points.begin(), sensor.points.end(),
                                             [&](const Point& point) { return !is_later(point); });
    for (auto point = sensor.points.begin(); point != later; ++point) {
      scan.points.push_back(point->p_sensor);
      if (has_intensities_) scan.intensities.push_back(point->intensity);
      times.push_back(point->nanoseconds);
    }
    if (later == sensor.points.begin()) continue;
    points.emplace_back(&sensor.account, later - sensor.points.begin());
    sensor.points.erase(sensor.points.begin(), later);
    scan.views.push_back({sensor.T_base_sensor, scan.points.size()});
    if (reading.frame_id.empty()) {
      reading.frame_id = sensor.frame_id;
      scan.T_base_sensor = sensor.T_base_sensor;
    }
  }
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  const auto latest_begin = static_cast<std::int64_t>(kLatestBegin * static_cast<double>(length_));
  const bool is_rest = (is_first && *first > window * length_ + latest_begin) ||
                       static_cast<double>(times.size()) < fewest;
  for (const auto& [account, count] : points)
    (is_rest ? account->points_dropped["rest of a sweep"] : account->points) += count;
  if (is_rest) return std::nullopt;
  scan.stamp = reading.header_stamp = {*last};
  for (const std::int64_t time : times)
    scan.times.push_back(static_cast<float>(1e-9 * static_cast<double>(time - *last)));
  reading.counts.received = reading.counts.kept = last_size_ = scan.points.size();
  return reading;
}

void SweepMerger::restart() {
  for (Sensor& sensor : sensors_) {
    sensor.points.clear();
    sensor.reached.reset();
    sensor.ahead.reset();
    sensor.account = {};
  }
  closed_until_.reset();
  has_intensities_ = false;
  last_size_ = 0;
}

std::size_t SweepMerger::held() const {
  return static_cast<std::size_t>(
      std::count_if(sensors_.begin(), sensors_.end(),
                    [](const Sensor& sensor) { return !sensor.points.empty() || sensor.ahead; }));
}

std::map<std::string, SensorAccount> SweepMerger::accounts() const {
  std::map<std::string, SensorAccount> accounts;
  if (merges())
    for (const Sensor& sensor : sensors_) accounts[sensor.topic] = sensor.account;
  return accounts;
}

}  // namespace revisit_slam
