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
constexpr std::int64_t kLeap = 1'000'000'000;  // ns
constexpr const char* kAhead = "stamp ahead of the next one";
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
      max_wait_(nanosecondsOf(config.max_wait)),
      leap_(std::max(kLeap, 2 * length_)) {
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
  for (Sensor& sensor : sensors_) sensor.then.resize(sensors_.size());
}

std::vector<ScanReading> SweepMerger::take(ScanReading reading) {
  std::vector<ScanReading> sweeps;
  Sensor& sensor = sensors_.at(reading.sensor);
  ++sensor.account.messages;
  reading.scan->stamp = reading.scan->stamp.plusSeconds(sensor.time_offset);
  const Stamp stamp = reading.scan->stamp;
  noteArrival(sensor, stamp);
  if (sensor.ahead) {
    ScanReading held = std::move(*std::exchange(sensor.ahead, std::nullopt));
    if (held.scan->stamp <= stamp)
      accept(std::move(held), sweeps);
    else
      drop(held, kAhead);
  }
  if (isLeap(stamp))
    sensor.ahead = std::move(reading);
  else
    accept(std::move(reading), sweeps);
  return sweeps;
}

/// How long each sensor has sent is counted by its own clock, which may leap.
void SweepMerger::noteArrival(Sensor& sensor, Stamp stamp) {
  if (sensor.sent)
    sensor.sent_for +=
        std::clamp<std::int64_t>(stamp.nanoseconds - sensor.sent->nanoseconds, 0, kLeap);
  sensor.sent = stamp;
  for (std::size_t i = 0; i < sensors_.size(); ++i) sensor.then[i] = sensors_[i].sent_for;
  std::optional<std::int64_t> newest_other;
  for (const Sensor& other : sensors_)
    if (&other != &sensor && other.sent && !hasGone(other))
      newest_other =
          std::max(newest_other.value_or(other.sent->nanoseconds), other.sent->nanoseconds);
  if (newest_other)
    sensor.account.behind = 1e-9 * static_cast<double>(*newest_other - stamp.nanoseconds);
}

/// It has sent nothing while another one has for some time.
bool SweepMerger::hasGone(const Sensor& sensor) const {
  if (!sensor.sent) return true;
  for (std::size_t i = 0; i < sensors_.size(); ++i)
    if (sensors_[i].sent_for - sensor.then[i] > leap_ + max_wait_) return true;
  return false;
}

/// That of most of the sensors that send, of which `sender` is one; of as many it stays what it
/// was.
void SweepMerger::chooseClock(std::size_t sender) {
  if (!clock_ || hasGone(sensors_[*clock_])) clock_ = sender;
  for (std::size_t i = 0; i < sensors_.size(); ++i)
    if (!hasGone(sensors_[i]) && agreeingWith(sensors_[i]) > agreeingWith(sensors_[*clock_]))
      clock_ = i;
}

/// How many of the sensors that send have its clock, by their last messages.
std::size_t SweepMerger::agreeingWith(const Sensor& sensor) const {
  return static_cast<std::size_t>(std::count_if(
      sensors_.begin(), sensors_.end(),
      [&](const Sensor& other) { return !hasGone(other) && isNear(*other.sent, *sensor.sent); }));
}

bool SweepMerger::isNear(Stamp a, Stamp b) const {
  return std::abs(a.nanoseconds - b.nanoseconds) <= leap_ + max_wait_;
}

bool SweepMerger::isOfAnotherClock(std::size_t sensor, Stamp stamp) const {
  const Sensor& clock = sensors_[*clock_];
  return sensor != *clock_ && clock.reached && !isNear(stamp, *clock.reached) &&
         !isNear(stamp, *clock.sent);  // which may be held, after a pause of all
}

/// Far ahead of what all have reached.
bool SweepMerger::isLeap(Stamp stamp) const {
  const std::int64_t reached = newest();
  return reached != std::numeric_limits<std::int64_t>::min() && stamp.nanoseconds > reached + leap_;
}

void SweepMerger::drop(const ScanReading& reading, const std::string& reason) {
  sensors_[reading.sensor].account.points_dropped[reason] += reading.scan->points.size();
}

void SweepMerger::accept(ScanReading reading, std::vector<ScanReading>& sweeps) {
  Sensor& sensor = sensors_[reading.sensor];
  const Scan& scan = *reading.scan;
  chooseClock(reading.sensor);
  if (isOfAnotherClock(reading.sensor, scan.stamp)) {
    sensor.is_awaited = false;
    return drop(reading, "of another clock");
  }
  const bool went_back = reading.sensor == *clock_ && closed_until_ &&
                         scan.stamp.nanoseconds < *closed_until_ * length_ - leap_ - max_wait_;
  if (went_back) {  // the clock: what follows is another session, which the stamp gate tells
    for (ScanReading& sweep : flush()) sweeps.push_back(std::move(sweep));
    for (Sensor& any : sensors_) any.reached.reset();
    closed_until_.reset();
  }
  has_intensities_ = has_intensities_ || !scan.intensities.empty();
  sensor.T_base_sensor = scan.T_base_sensor;
  sensor.frame_id = reading.frame_id;
  if (!sensor.reached || *sensor.reached < scan.stamp) sensor.reached = scan.stamp;
  const bool is_in_time = newest() - scan.stamp.nanoseconds < std::max<std::int64_t>(max_wait_, 1);
  if (is_in_time || (closed_until_ && scan.stamp.nanoseconds >= *closed_until_ * length_))
    sensor.is_awaited = true;
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
    else {
      sensor.points.push_back(point);
      sensor.oldest = std::min(sensor.oldest, point.nanoseconds);
    }
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
    return !sensor.is_awaited || (sensor.reached && sensor.reached->nanoseconds >= end);
  });
}

/// Of those that have points.
std::optional<std::int64_t> SweepMerger::oldestWindow() const {
  std::int64_t oldest = kNever;
  for (const Sensor& sensor : sensors_) oldest = std::min(oldest, sensor.oldest);
  if (oldest == kNever) return std::nullopt;
  return oldest / length_;
}

void SweepMerger::close(std::vector<ScanReading>& sweeps) {
  while (const std::optional<std::int64_t> window = oldestWindow()) {
    const std::int64_t end = (*window + 1) * length_;
    const bool waited = newest() >= end + max_wait_;
    if (!allReach(end) && !waited) return;
    if (waited)
      for (Sensor& sensor : sensors_)
        if (!sensor.reached || sensor.reached->nanoseconds < end) sensor.is_awaited = false;
    if (std::optional<ScanReading> sweep = closeWindow(*window))
      sweeps.push_back(std::move(*sweep));
  }
}

std::vector<ScanReading> SweepMerger::flush() {
  std::vector<ScanReading> sweeps;
  for (Sensor& sensor : sensors_) {
    if (sensor.ahead) drop(*sensor.ahead, kAhead);
    sensor.ahead.reset();
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
    sensor.oldest = kNever;
    for (const Point& point : sensor.points)
      sensor.oldest = std::min(sensor.oldest, point.nanoseconds);
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
    sensor.oldest = kNever;
    sensor.reached.reset();
    sensor.ahead.reset();
    sensor.sent.reset();
    sensor.sent_for = 0;
    std::fill(sensor.then.begin(), sensor.then.end(), 0);
    sensor.is_awaited = true;
    sensor.account = {};
  }
  clock_.reset();
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
  if (!merges()) return accounts;
  for (const Sensor& sensor : sensors_) {
    SensorAccount& account = accounts[sensor.topic] = sensor.account;
    account.is_silent = !sensor.is_awaited && hasGone(sensor);
    account.is_late = !sensor.is_awaited && !account.is_silent;
  }
  return accounts;
}

}  // namespace revisit_slam
