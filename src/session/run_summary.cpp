// SPDX-License-Identifier: MIT
#include "revisit_slam/session/run_summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "revisit_slam/io/parameter_file.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/session/session_info.h"
#include "revisit_slam/util/process_usage.h"
#include "revisit_slam/util/quantile.h"

namespace revisit_slam {
namespace {

using nlohmann::json;

json statistics(const std::map<std::string, std::vector<float>>& stage_ms) {
  json all = json::object();
  for (const auto& [stage, ms] : stage_ms)
    all[stage] = {
        {"median", quantile(ms, 0.5)}, {"p99", quantile(ms, 0.99)}, {"max", quantile(ms, 1.0)}};
  return all;
}

json toJson(const std::map<std::string, PriorAccount>& priors) {
  json all = json::object();
  for (const auto& [sensor, account] : priors) {
    all[sensor] = {
        {"messages", {{"received", account.received}, {"dropped", account.dropped}}},
        {"scans",
         {{"used", account.used}, {"rejected", account.rejected}, {"missing", account.missing}}}};
    if (account.scale) all[sensor]["scale"] = *account.scale;
    if (const auto& bias = account.bias) all[sensor]["bias"] = {bias->x(), bias->y(), bias->z()};
  }
  return all;
}

json toJson(const std::map<std::string, SensorAccount>& lidars) {
  json all = json::object();
  for (const auto& [topic, account] : lidars)
    all[topic] = {{"messages", account.messages},
                  {"points", {{"used", account.points}, {"dropped", account.points_dropped}}}};
  return all;
}

void add(const InputSummary& input, json& run) {
  const ScanAccount& account = input.account;
  run["scans"]["received"] = account.received;
  run["scans"]["at_rest"] = account.at_rest;
  run["scans"]["joined"] = account.joined;
  run["scans"]["dropped"] = account.dropped;
  run["points"] = {{"received", account.points_received}, {"dropped", account.points_dropped}};
  run["priors"] = toJson(input.priors);
  if (!input.lidars.empty()) run["lidars"] = toJson(input.lidars);
  run["time_source"] = input.time_source;
}

template <typename Value>
void addKnown(const char* key, const std::optional<Value>& value, json& run) {
  if (value) run[key] = *value;
}

}  // namespace

void judge(const MapConsistency& consistency, RunSummary& summary) {
  summary.revisited_cells = consistency.cells.size();
  if (consistency.cells.empty()) return;
  summary.consistency_mean = consistency.of_pairs.mean;
  summary.consistency_deviation = consistency.of_pairs.standard_deviation;
}

void writeRunSummary(const std::string& path, const RunSummary& summary) {
  const double scans = std::max<double>(1.0, static_cast<double>(summary.processed));
  json verdicts = json::object();
  for (const auto& [verdict, count] : summary.verdicts) verdicts[toString(verdict)] = count;
  json run = {
      {"version", softwareVersion()},
      {"interrupted", summary.interrupted},
      {"topic", summary.topic},
      {"tracked_frame", summary.tracked_frame},
      {"parameters", revisit_slam::toJson(summary.parameters)},
      {"scans", {{"processed", summary.processed}}},
      {"poses", verdicts},
      {"path_length_m", summary.path_length},
      {"cpu_seconds", processCpuSeconds()},
      {"cpu_seconds_per_scan", (processCpuSeconds() - summary.reading_cpu_seconds) / scans},
      {"stages_ms", statistics(summary.stage_ms)},
      {"peak_memory_mb", peakMemoryMegabytes()},
      {"loops", summary.loops},
      {"optimisations", summary.optimisations},
      {"rejected_optimisations", summary.rejected_optimisations},
      {"revisit_consistency",
       {{"cells", summary.revisited_cells},
        {"rms_mean_m", summary.consistency_mean},
        {"rms_standard_deviation_m", summary.consistency_deviation}}},
      {"threads", summary.threads},
  };
  if (summary.input) add(*summary.input, run);
  addKnown("wall_seconds", summary.wall_seconds, run);
  addKnown("finish_seconds", summary.finish_seconds, run);
  addKnown("memory_mb_per_km", summary.memory_mb_per_km, run);
  addKnown("retroactive_pairs", summary.retroactive_pairs, run);
  writeWholeText(path, run.dump(2) + "\n");
}

}  // namespace revisit_slam
