// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/input_watch.h"

#include <algorithm>
#include <cstdio>

#include "revisit_slam/slam/drop_remedies.h"

namespace revisit_slam {
namespace {

/// A driver needs some time to start, and scans are late now and then.
constexpr double kPatience = 3.0;  // s
constexpr double kPeriods = 10.0;
/// Over which a rate is measured, s.
constexpr double kWindow = 5.0;

using Level = InputWatch::Level;
using Fault = InputWatch::Fault;
using Verdict = InputWatch::Verdict;

std::string number(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " and ") + word;
  return text;
}

std::string whySilent(const InputState& state) {
  return describeSilence(state.topics, state.published, state.several_sensors);
}

/// With another session an account begins at zero.
bool isAnew(const ScanAccount& account, const ScanAccount& before) {
  return account.received < before.received || account.processed < before.processed ||
         account.droppedInAll() < before.droppedInAll();
}

/// What comes and goes, and is logged scan by scan.
bool isSmall(Fault fault) {
  return fault == Fault::none || fault == Fault::some_dropped;
}

std::map<std::string, std::size_t> newDrops(const ScanAccount& account, const ScanAccount& before) {
  std::map<std::string, std::size_t> drops;
  for (const auto& [reason, count] : account.dropped) {
    const auto old = before.dropped.find(reason);
    const std::size_t known = old == before.dropped.end() ? 0 : old->second;
    if (count > known) drops[reason] = count - known;
  }
  return drops;
}

}  // namespace

bool InputWatch::isSilent(double now, std::size_t arrived) const {
  if (!start_) return false;
  const bool has_come = !arrivals_.empty() && arrived > arrivals_.back().arrived;
  if (has_come) return false;
  if (arrived == 0) return now - *start_ >= kPatience;
  const double patience = std::max(kPatience, last_rate_ > 0.0 ? kPeriods / last_rate_ : 0.0);
  return now - last_arrival_ >= patience;
}

Verdict InputWatch::look(const InputState& state) {
  Verdict verdict;
  note(state);
  if (const auto arrival = judgeArrival(state)) {
    verdict = *arrival;
  } else if (!state.transform_fault.empty()) {
    verdict = judgeTransform(state);
  } else if (const auto drops = judgeDrops(state)) {
    verdict = *drops;
  } else if (!state.time_fault.empty()) {
    verdict = {Level::warn, Fault::no_times, state.time_fault, false};
  } else {
    verdict.sentence = state.arrived == 0
                           ? "no scan yet on " + join(state.topics)
                           : number("%.1f", rate()) + " scans/s on " + join(state.topics);
  }
  const std::string cause = verdict.fault == Fault::nothing_comes ? whySilent(state) : "";
  verdict.is_new =
      cause != cause_ || (verdict.fault != fault_ && !(isSmall(verdict.fault) && isSmall(fault_)));
  cause_ = cause;
  fault_ = verdict.fault;
  before_ = state.account;
  return verdict;
}

void InputWatch::note(const InputState& state) {
  if (!start_) start_ = state.now;
  const std::size_t known = arrivals_.empty() ? 0 : arrivals_.back().arrived;
  if (state.arrived > known) last_arrival_ = state.now;
  arrivals_.push_back({state.now, state.arrived});
  while (arrivals_.size() > 2 && state.now - arrivals_.front().now > kWindow) arrivals_.pop_front();
  if (state.arrived > known && rate() > 0.0) last_rate_ = rate();
  if (isAnew(state.account, before_)) before_ = {};
  newly_dropped_ = newDrops(state.account, before_);
  newly_processed_ = state.account.processed - before_.processed;
}

double InputWatch::rate() const {
  const double seconds = arrivals_.back().now - arrivals_.front().now;
  if (!(seconds > 0.0)) return 0.0;
  return static_cast<double>(arrivals_.back().arrived - arrivals_.front().arrived) / seconds;
}

std::optional<Verdict> InputWatch::judgeArrival(const InputState& state) const {
  const bool is_silent = isSilent(state.now, state.arrived);
  if (!state.clock_runs && state.now - *start_ >= kPatience)
    return Verdict{Level::warn, Fault::clock,
                   "/use_sim_time is true, but nobody publishes /clock: play recordings with "
                   "rosbag play --clock, or for a live sensor call rosparam set /use_sim_time "
                   "false and restart all nodes",
                   false};
  if (!is_silent) return std::nullopt;
  if (state.arrived == 0)
    return Verdict{Level::warn, Fault::nothing_comes,
                   "no scan in " + number("%.0f", state.now - *start_) + " s: " + whySilent(state),
                   false};
  return Verdict{Level::warn, Fault::stopped, describeStop(state), false};
}

std::string InputWatch::describeStop(const InputState& state) const {
  return "no scan for " + number("%.0f", state.now - last_arrival_) +
         " s (before: " + number("%.1f", last_rate_) + " scans/s): " + whySilent(state) +
         "; at the end of the drive call back_end/finish";
}

/// Scans of other sensors may go on.
Verdict InputWatch::judgeTransform(const InputState& state) const {
  const bool none_goes_on = newly_processed_ == 0;
  return {none_goes_on ? Level::error : Level::warn, Fault::transform,
          (none_goes_on ? std::to_string(state.waiting + 1) + " scans wait: "
                        : std::string("some messages are dropped: ")) +
              state.transform_fault,
          false};
}

/// What was dropped since the last look.
std::optional<Verdict> InputWatch::judgeDrops(const InputState& state) const {
  if (newly_dropped_.empty()) return std::nullopt;
  const auto most =
      std::max_element(newly_dropped_.begin(), newly_dropped_.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most->first == "queue full")
    return Verdict{Level::warn, Fault::overload, describeOverload(state, most->second), false};
  const bool all = newly_processed_ == 0;
  const std::string remedy = remedyForDrop(most->first);
  return Verdict{all ? Level::error : Level::warn, all ? Fault::all_dropped : Fault::some_dropped,
                 (all ? "all scans are dropped, " : "scans are dropped, ") +
                     std::to_string(most->second) + " of late: " + most->first +
                     (remedy.empty() ? "" : ": " + remedy),
                 false};
}

std::string InputWatch::describeOverload(const InputState& state, std::size_t dropped) const {
  const double merged = state.several_sensors ? static_cast<double>(state.topics.size()) : 1.0;
  const double sweeps = last_rate_ / merged;  // Hz
  const bool too_slow = state.scan_seconds * sweeps > 1.0;
  return "the odometry does not keep up, " + std::to_string(dropped) +
         " scans were dropped of late: scans come every " +
         number("%.0f", sweeps > 0.0 ? 1e3 / sweeps : 0.0) + " ms and take " +
         number("%.0f", 1e3 * state.scan_seconds) + " ms each" +
         (too_slow ? ": give it more threads (odometry/threads), or scans with fewer points "
                     "(odometry/map/voxel_size higher, odometry/max_range lower)"
                   : ": the machine was busy with something else; raise live/queue_size for short "
                     "bursts");
}

}  // namespace revisit_slam
