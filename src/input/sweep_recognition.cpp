// SPDX-License-Identifier: MIT
#include "revisit_slam/input/sweep_recognition.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace revisit_slam {
namespace {

/// How often messages are looked at in a row. Those that come more often than every kGroupSeconds
/// are looked at in groups: a packet covers too few degrees to say how they go on.
constexpr std::size_t kGroups = 4;
constexpr double kGroupSeconds = 0.015;
constexpr std::size_t kLargestGroup = 50;
/// Wider sectors are the full circle, some of it without returns.
constexpr double kFullCircle = 300.0;
/// Of so many times, evenly taken, the first is looked for.
constexpr std::size_t kSamples = 4000;
/// Fewer points have no sector.
constexpr std::size_t kFewestPoints = 20;
/// Sweeps of a fixed field of view that come more often, s, are joined to usual ones, s.
constexpr double kShortestInterval = 1.0 / 30.0;
constexpr double kUsualSweep = 0.1;
/// Messages further apart, s, are not parts of one sweep.
constexpr double kLongestInterval = 0.25;
/// So many judgements in a row change what was decided: stamps of messages that were held up come
/// in a burst, and parts may be lost.
constexpr int kPersistence = 8;
/// Sweeps that last so much longer than it takes to the next one overlap.
constexpr double kOverlap = 1.3;

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g ms", seconds * 1e3);
  return text;
}

double durationOf(const Scan& scan) {
  const std::size_t step = std::max<std::size_t>(1, scan.times.size() / kSamples) | 1;
  float first = 0.f;
  for (std::size_t i = 0; i < scan.times.size(); i += step) first = std::min(first, scan.times[i]);
  return -static_cast<double>(first);
}

bool isFullCircle(const ViewSector& sector) {
  return sector.width >= kFullCircle;
}

/// Whether the second sector begins behind the middle of the first.
bool hasMoved(const ViewSector& from, const ViewSector& to) {
  if (isFullCircle(from) || isFullCircle(to)) return false;
  return std::abs(turnBetween(from.middle, to.middle)) >= 0.5 * std::min(from.width, to.width);
}

}  // namespace

SweepRecognition::SweepRecognition(const ScanInputConfig& config)
    : is_automatic_(config.sweeps == "auto"), given_seconds_(config.scan_period) {}

void SweepRecognition::add(const Scan& scan, const std::string& frame_id) {
  const double elapsed =
      messages_.empty() ? 0.0 : secondsBetween(messages_.back().stamp, scan.stamp);
  const bool follows =
      messages_.empty() || (frame_id == frame_id_ && elapsed > 0.0 && elapsed < kLongestInterval);
  if (!follows) messages_.clear();
  frame_id_ = frame_id;
  Message message{scan.stamp, durationOf(scan), {}, false};
  message.directions.add(scan.points);
  message.is_full_circle = isFullCircle(message.directions.sector());
  const bool is_sweep =
      !(given_seconds_ > 0.0) && message.is_full_circle && message.seconds < kOverlap * kUsualSweep;
  messages_.push_back(std::move(message));
  if (!is_decided_ && (!follows || is_sweep || scan.points.size() < kFewestPoints)) decide({});
  judge();
}

void SweepRecognition::judge() {
  if (messages_.size() < 2) return;
  interval_ = secondsBetween(messages_.front().stamp, messages_.back().stamp) /
              static_cast<double>(messages_.size() - 1);
  const std::size_t in_group = messagesInGroup();
  if (messages_.size() < kGroups * in_group) return;
  SweepForm form;
  form.stretch = stretch();
  if (is_automatic_) form.sweep_seconds = sweepSeconds(in_group);
  const bool same = form.sweep_seconds == form_.sweep_seconds && form.stretch == form_.stretch;
  contrary_ = same ? 0 : contrary_ + 1;
  if (!is_decided_ || contrary_ >= kPersistence) decide(form);
  while (messages_.size() >= kGroups * in_group) messages_.pop_front();
}

std::size_t SweepRecognition::messagesInGroup() const {
  const double count = std::ceil(kGroupSeconds / interval_);
  return static_cast<std::size_t>(std::clamp(count, 1.0, static_cast<double>(kLargestGroup)));
}

/// Stays what it was found to be, so that the stamps that are corrected with it do not waver.
double SweepRecognition::stretch() const {
  std::vector<double> durations;
  for (const Message& message : messages_) durations.push_back(message.seconds);
  const auto [shortest, longest] = std::minmax_element(durations.begin(), durations.end());
  const bool overlap = *shortest > kOverlap * interval_;
  if (form_.stretch > 0.0) return *longest > kOverlap * interval_ ? form_.stretch : 0.0;
  return overlap ? *longest / interval_ : 0.0;
}

double SweepRecognition::sweepSeconds(std::size_t messages_in_group) const {
  const auto isFull = [](const Message& message) { return message.is_full_circle; };
  if (std::all_of(messages_.begin(), messages_.end(), isFull)) return 0.0;
  if (given_seconds_ > 0.0) return kOverlap * interval_ < given_seconds_ ? given_seconds_ : 0.0;
  std::vector<Group> groups;
  for (std::size_t i = 0; i < kGroups; ++i)
    groups.push_back(groupOf(i * messages_in_group, messages_in_group));
  // A group turns as its middle does. Of single messages, which may be halves, only the width
  // tells.
  std::vector<double> revolutions;  // s
  for (std::size_t i = 1; i < kGroups; ++i) {
    const Group &from = groups[i - 1], &to = groups[i];
    if (!hasMoved(from.sector, to.sector)) continue;
    const double turn = std::abs(turnBetween(from.sector.middle, to.sector.middle));
    revolutions.push_back(messages_in_group > 1 ? 360.0 * (to.seconds_to - from.seconds_to) / turn
                                                : 360.0 * to.seconds / to.sector.width);
  }
  std::sort(revolutions.begin(), revolutions.end());
  // A lost part makes one of the three steps another one.
  if (revolutions.size() + 1 >= kGroups - 1) {
    if (form_.sweep_seconds > 0.0) return form_.sweep_seconds;
    const double revolution = revolutions[revolutions.size() / 2];
    return revolution > kOverlap * shortestInterval() ? std::min(revolution, 1.0) : 0.0;
  }
  if (!revolutions.empty()) return form_.sweep_seconds;
  return interval_ < kShortestInterval ? kUsualSweep : 0.0;
}

double SweepRecognition::shortestInterval() const {
  double shortest = interval_;
  for (std::size_t i = 1; i < messages_.size(); ++i)
    shortest = std::min(shortest, secondsBetween(messages_[i - 1].stamp, messages_[i].stamp));
  return shortest;
}

/// It lasts from its first point on or, where messages have no times, as long as they are apart.
SweepRecognition::Group SweepRecognition::groupOf(std::size_t begin, std::size_t count) const {
  Group group;
  ViewedDirections directions;
  for (std::size_t i = begin; i < begin + count; ++i) {
    directions.add(messages_[i].directions);
    group.seconds_to +=
        secondsBetween(messages_.front().stamp, messages_[i].stamp) / static_cast<double>(count);
  }
  const Message &first = messages_[begin], &last = messages_[begin + count - 1];
  const bool has_times = first.seconds > 0.0 && first.seconds <= kOverlap * interval_;
  group.seconds =
      secondsBetween(first.stamp, last.stamp) + (has_times ? first.seconds : shortestInterval());
  group.sector = directions.sector();
  return group;
}

void SweepRecognition::decide(const SweepForm& form) {
  const bool was_decided = std::exchange(is_decided_, true);
  contrary_ = 0;
  form_ = form;
  description_.clear();
  if (form.sweep_seconds > 0.0)
    description_ = "messages come every " + milliseconds(interval_) +
                   " and hold parts of sweeps: sweeps of " + milliseconds(form.sweep_seconds) +
                   " are assembled from them";
  if (form.stretch > 0.0)
    description_ += std::string(description_.empty() ? "" : "; ") + "point times are not used, " +
                    (form.sweep_seconds > 0.0 ? "stamps of messages are" : "deskewing off") +
                    ": by them a message lasts " + milliseconds(form.stretch * interval_) +
                    ", but messages come every " + milliseconds(interval_) +
                    "; set input/time_unit or input/time_field (azimuth for a spinning sensor)";
  if (was_decided && description_.empty())
    description_ = "every message is a sweep with usable times";
}

}  // namespace revisit_slam
