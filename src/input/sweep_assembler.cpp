// SPDX-License-Identifier: MIT
#include "revisit_slam/input/sweep_assembler.h"

#include <algorithm>
#include <utility>

namespace revisit_slam {
namespace {

/// Sweeps of which less is there are too small to be registered.
constexpr double kSmallestPart = 0.25;

/// The stamp is that of a last point with a time that is as much too late.
void refuseTimes(ScanReading& reading, double stretch) {
  Scan& scan = *reading.scan;
  scan.times.clear();
  const double after_header = secondsBetween(reading.header_stamp, scan.stamp);
  scan.stamp = reading.header_stamp.plusSeconds(after_header / stretch);
}

void append(const Scan& part, Stamp stamp, Scan& sweep) {
  const auto shift = static_cast<float>(secondsBetween(stamp, part.stamp));
  sweep.points.insert(sweep.points.end(), part.points.begin(), part.points.end());
  if (part.times.empty()) {
    sweep.times.resize(sweep.points.size(), shift);
  } else {
    for (const float time : part.times) sweep.times.push_back(std::min(0.f, time + shift));
  }
  if (part.intensities.empty() && sweep.intensities.empty()) return;
  sweep.intensities.resize(sweep.points.size() - part.points.size());
  sweep.intensities.insert(sweep.intensities.end(), part.intensities.begin(),
                           part.intensities.end());
  sweep.intensities.resize(sweep.points.size());
}

ScanReading join(std::vector<ScanReading> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  Stamp stamp = parts.front().scan->stamp;
  std::size_t points = 0;
  for (const ScanReading& part : parts) {
    stamp = std::max(stamp, part.scan->stamp);
    points += part.scan->points.size();
  }
  ScanReading joined;
  joined.frame_id = parts.back().frame_id;
  joined.header_stamp = parts.back().header_stamp;
  joined.counts = {};
  Scan& sweep = joined.scan.emplace();
  sweep.stamp = stamp;
  sweep.T_base_sensor = parts.back().scan->T_base_sensor;
  sweep.points.reserve(points);
  sweep.times.reserve(points);
  for (const ScanReading& part : parts) {
    append(*part.scan, stamp, sweep);
    joined.counts.received += part.counts.received;
    joined.counts.not_finite += part.counts.not_finite;
    joined.counts.at_origin += part.counts.at_origin;
    joined.counts.no_time += part.counts.no_time;
    joined.counts.kept += part.counts.kept;
  }
  return joined;
}

}  // namespace

std::vector<SweepAssembler::Sweep> SweepAssembler::take(ScanReading reading) {
  std::vector<Sweep> sweeps;
  recognition_.add(*reading.scan, reading.frame_id);
  undecided_.push_back(std::move(reading));
  if (!recognition_.isDecided()) return sweeps;
  for (ScanReading& held : std::exchange(undecided_, {})) insert(std::move(held), sweeps);
  return sweeps;
}

std::vector<SweepAssembler::Sweep> SweepAssembler::flush() {
  std::vector<Sweep> sweeps;
  for (ScanReading& held : std::exchange(undecided_, {})) insert(std::move(held), sweeps);
  close(sweeps);
  return sweeps;
}

void SweepAssembler::insert(ScanReading reading, std::vector<Sweep>& sweeps) {
  const SweepForm& form = recognition_.form();
  if (form.stretch > 0.0) refuseTimes(reading, form.stretch);
  if (!(form.sweep_seconds > 0.0)) {
    close(sweeps);
    sweeps.push_back({std::move(reading), 1, {}});
    return;
  }
  if (!continues(reading)) close(sweeps);
  parts_.push_back(std::move(reading));
  if (lasted() >= form.sweep_seconds - tolerance()) close(sweeps);
}

/// Where points have no times, the message is held to last until the next.
Stamp SweepAssembler::beginOf(const Scan& scan) const {
  if (scan.times.empty()) return scan.stamp.plusSeconds(-recognition_.interval());
  return scan.stamp.plusSeconds(*std::min_element(scan.times.begin(), scan.times.end()));
}

/// Of the sweep that has begun, s.
double SweepAssembler::lasted() const {
  return secondsBetween(beginOf(*parts_.front().scan), parts_.back().scan->stamp);
}

bool SweepAssembler::continues(const ScanReading& reading) const {
  if (parts_.empty() || reading.frame_id != parts_.back().frame_id) return false;
  const Stamp begin = beginOf(*parts_.front().scan);
  const double lasts = secondsBetween(begin, reading.scan->stamp);
  return beginOf(*reading.scan) >= begin &&
         lasts <= recognition_.form().sweep_seconds + tolerance();
}

/// Half a message: which sweep a message belongs to is decided by its middle.
double SweepAssembler::tolerance() const {
  return 0.5 * std::min(recognition_.interval(), 0.5 * recognition_.form().sweep_seconds);
}

void SweepAssembler::close(std::vector<Sweep>& sweeps) {
  if (parts_.empty()) return;
  const std::size_t messages = parts_.size();
  const bool too_small = lasted() < kSmallestPart * recognition_.form().sweep_seconds;
  Sweep sweep{join(std::exchange(parts_, {})), messages, {}};
  if (too_small) sweep.refusal = "too small a part of a sweep";
  sweeps.push_back(std::move(sweep));
}

}  // namespace revisit_slam
