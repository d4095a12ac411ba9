// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/report.h"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <set>
#include <stdexcept>

namespace revisit_slam::simulation {
namespace {

constexpr std::int64_t kTruthPeriod = 10000000;
constexpr std::int64_t kSecond = 1000000000;

std::ofstream openForWriting(const std::string& path) {
  std::ofstream file(path);
  if (!file) throw std::runtime_error("cannot write " + path);
  return file;
}

void requireWhole(std::ofstream& file, const std::string& path) {
  file.flush();
  if (!file) throw std::runtime_error("could not write all of " + path);
}

std::string truthLine(Stamp stamp, const Pose& T) {
  char line[256];
  const auto& p = T.translation;
  const auto& q = T.rotation;
  std::snprintf(line, sizeof(line),
                "%" PRId64 ".%09" PRId64 " %.9f %.9f %.9f %.12f %.12f %.12f %.12f\n",
                stamp.nanoseconds / kSecond, stamp.nanoseconds % kSecond, p.x(), p.y(), p.z(),
                q.x(), q.y(), q.z(), q.w());
  return line;
}

void writeRevisit(std::ofstream& file, const Revisit& revisit) {
  file << R"(    {"kind": )" << quoted(nameOf(revisit.kind)) << R"(, "earlier": [)"
       << revisit.earlier_from.nanoseconds << ", " << revisit.earlier_until.nanoseconds
       << R"(], "later": [)" << revisit.later_from.nanoseconds << ", "
       << revisit.later_until.nanoseconds << "]}";
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) result += c;
  }
  return result + "\"";
}

void writeTruth(const std::string& path, const Route& route, const std::vector<Stamp>& stamps) {
  std::set<Stamp> instants(stamps.begin(), stamps.end());
  const std::int64_t start = route.start().nanoseconds;
  const std::int64_t end = stamps.empty() ? start : instants.rbegin()->nanoseconds + kTruthPeriod;
  for (std::int64_t t = start; t <= end; t += kTruthPeriod) instants.insert(Stamp{t});
  std::ofstream file = openForWriting(path);
  for (const Stamp stamp : instants) file << truthLine(stamp, route.poseAt(stamp));
  requireWhole(file, path);
}

void writeReport(const std::string& path, const DriveReport& report) {
  std::ofstream file = openForWriting(path);
  file << "{\n  \"options\": {\n";
  for (std::size_t i = 0; i < report.options.size(); ++i) {
    file << "    " << quoted(report.options[i].first) << ": " << report.options[i].second
         << (i + 1 < report.options.size() ? ",\n" : "\n");
  }
  file << "  },\n  \"scans\": " << report.scans << ",\n  \"points\": " << report.points
       << ",\n  \"length\": " << report.length << ",\n  \"triangles\": " << report.triangles
       << ",\n  \"moving_cars\": " << report.moving_cars << ",\n  \"people\": " << report.people
       << ",\n  \"start\": " << report.start.nanoseconds
       << ",\n  \"end\": " << report.end.nanoseconds << ",\n  \"revisits\": [\n";
  for (std::size_t i = 0; i < report.revisits.size(); ++i) {
    writeRevisit(file, report.revisits[i]);
    file << (i + 1 < report.revisits.size() ? ",\n" : "\n");
  }
  file << "  ]\n}\n";
  requireWhole(file, path);
}

}  // namespace revisit_slam::simulation
