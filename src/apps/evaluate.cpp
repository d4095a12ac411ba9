// SPDX-License-Identifier: MIT
// Judges trajectories against a reference, and the maps they make against themselves.
#include <sensor_msgs/PointCloud2.h>
#include <tbb/task_arena.h>
#include <topic_tools/shape_shifter.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "revisit_slam/evaluation/estimate_judge.h"
#include "revisit_slam/input/sweep_assembler.h"
#include "revisit_slam/io/parameter_file.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/ros/input/bag_scans.h"
#include "revisit_slam/ros/input/scan_reader.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/util/progress.h"

namespace revisit_slam {
namespace {

/// frames, input and odometry as the run had them: they say how scans are read.
struct EvaluateConfig {
  FramesConfig frames;
  ScanInputConfig input;
  OdometryConfig odometry;
  ConsistencyConfig consistency;

  template <typename Visitor>
  void visit(Visitor& v) {
    v.group("frames", frames);
    v.group("input", input);
    v.group("odometry", odometry);
    v.group("consistency", consistency);
  }
};

struct Options {
  std::string reference, topic, out;
  std::vector<std::string> estimates, bags, settings;
  int threads = 2;
  bool quiet = false;
  EvaluateConfig config;
};

Options parseOptions(CLI::App& app, int argc, char** argv) {
  Options options;
  app.add_option("--reference", options.reference, "TUM file of the true trajectory, z up");
  app.add_option("--estimate", options.estimates, "NAME=FILE, a TUM or KITTI file; may be repeated")
      ->required()
      ->take_all();
  app.add_option("--bag", options.bags, "bag with the scans: judges the maps too");
  app.add_option("--points,--topic", options.topic,
                 "topic of the scans; may be left out when there is one");
  app.add_option("--set", options.settings, "one parameter, as group/name=value")->take_all();
  app.add_option("--out", options.out, "folder for evaluation.json and the data of pictures");
  app.add_option("--threads", options.threads, "threads; results do not depend on it")
      ->check(CLI::Range(1, 64));
  app.add_flag("--quiet", options.quiet, "no progress");
  app.parse(argc, argv);
  assign(parametersOf(options.config), parseSettings(options.settings));
  if (!options.config.input.topics.empty())
    throw ParameterError(
        "input/topics: maps are judged by the scans of one LiDAR: name its topic with --points");
  return options;
}

/// Reads the bag once for all.
void insertScans(const Options& options, std::vector<EstimateJudge>& judges) {
  BagScans bag(options.bags, options.topic);
  ScanReader reader(options.config.input);
  SweepAssembler assembler(options.config.input);
  const auto insert = [&](const std::vector<SweepAssembler::Sweep>& sweeps) {
    for (const SweepAssembler::Sweep& sweep : sweeps) {
      if (!sweep.refusal.empty()) continue;
      for (EstimateJudge& judge : judges)
        judge.insert(*sweep.reading.scan, options.config.odometry);
    }
  };
  const std::string& base = options.config.frames.base;
  const bool of_sensor = base.empty() || !bag.hasTransforms();
  std::optional<Pose> T_base_sensor;
  if (of_sensor) T_base_sensor = Pose::identity();
  Progress progress("reading", "scans", bag.size(), options.quiet);
  std::size_t done = 0, rejected = 0;
  for (const rosbag::MessageInstance& instance : bag.messages()) {
    ScanReading reading = readScan(instance, reader);
    progress.update(++done);
    rejected += !reading.scan;
    if (!reading.scan) continue;
    if (!T_base_sensor) T_base_sensor = bag.findExtrinsics(base, reading.frame_id);
    if (!T_base_sensor)
      throw BagError(
          "the bag has no transform from '" + reading.frame_id + "' to '" + base +
          "'; set frames/base to a frame that it has, or to nothing for the sensor's own");
    reading.scan->T_base_sensor = *T_base_sensor;
    insert(assembler.take(std::move(reading)));
  }
  insert(assembler.flush());
  if (rejected > 0) progress.say(std::to_string(rejected) + " scans could not be read");
  for (EstimateJudge& judge : judges) judge.compareMaps();
  progress.finish();
}

std::string cell(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof(text), "%.*f", digits, value);
  return text;
}

std::vector<std::string> tableRow(const EstimateEvaluation& e) {
  std::vector<std::string> row{e.name, std::to_string(e.estimate.size())};
  if (e.trajectory) {
    const auto& [match, ate, rpe] = *e.trajectory;
    row.insert(row.end(), {std::to_string(match.outside + match.in_gap), cell(ate.rmse, 3),
                           cell(ate.median, 3), cell(ate.max, 3), cell(rpe.translation_percent, 3),
                           cell(rpe.rotation_deg_per_m, 5)});
  }
  if (e.consistency)
    row.insert(
        row.end(),
        {std::to_string(e.consistency->of_pairs.count), cell(e.consistency->of_pairs.mean, 4),
         cell(e.consistency->of_pairs.standard_deviation, 4), cell(e.consistency->of_cells.mean, 4),
         cell(e.consistency->thickness.rms(), 4), cell(100.0 * e.consistency->share, 1)});
  return row;
}

void printTable(const std::vector<EstimateJudge>& judges) {
  const EstimateEvaluation& first = judges.front().evaluation();
  std::vector<std::vector<std::string>> table{{"estimate", "poses"}};
  if (first.trajectory)
    table[0].insert(table[0].end(), {"left out", "ATE [m]", "median", "max", "RPE [%]", "[deg/m]"});
  if (first.consistency)
    table[0].insert(table[0].end(), {"pairs of maps", "RMS [m]", "std", "pooled RMS [m]",
                                     "thickness [m]", "paired [%]"});
  for (const EstimateJudge& judge : judges) table.push_back(tableRow(judge.evaluation()));
  for (const auto& row : table) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      std::size_t width = 0;
      for (const auto& other : table) width = std::max(width, other[column].size());
      std::printf(column == 0 ? "%-*s" : "  %*s", static_cast<int>(width), row[column].c_str());
    }
    std::puts("");
  }
}

void writeFiles(const Options& options, const std::vector<EstimateJudge>& judges) {
  std::filesystem::create_directories(options.out);
  EvaluateConfig config = options.config;
  nlohmann::json all = {{"reference", options.reference},
                        {"parameters", toJson(parametersOf(config))},
                        {"estimates", nlohmann::json::array()}};
  for (const EstimateJudge& judge : judges) {
    const EstimateEvaluation& evaluation = judge.evaluation();
    const std::string end = "_" + evaluation.name + ".csv";
    writeWholeText(options.out + "/poses" + end, posesCsv(evaluation));
    if (evaluation.consistency)
      writeWholeText(options.out + "/worst_cells" + end, worstCellsCsv(*evaluation.consistency));
    all["estimates"].push_back(toJson(evaluation));
  }
  writeWholeText(options.out + "/evaluation.json", all.dump(1) + "\n");
}

std::vector<EstimateJudge> readEstimates(const Options& options) {
  std::optional<PoseInterpolator> reference;
  if (!options.reference.empty()) reference.emplace(readTrajectory(options.reference));
  std::vector<EstimateJudge> judges;
  for (const std::string& named : options.estimates) {
    const std::size_t equals = named.find('=');
    const std::string name = named.substr(0, equals);
    if (equals == std::string::npos || name.empty() || name.find('/') != std::string::npos)
      throw ParameterError("--estimate " + named + " is not of the form NAME=FILE");
    for (const EstimateJudge& other : judges)
      if (other.evaluation().name == name)
        throw ParameterError("--estimate " + named + ": there are two of this name");
    Trajectory poses =
        readTrajectory(named.substr(equals + 1), reference ? reference->poses() : Trajectory{});
    judges.emplace_back(name, PoseInterpolator(std::move(poses)), reference,
                        options.config.consistency);
  }
  return judges;
}

void run(const Options& options) {
  if (options.reference.empty() && options.bags.empty())
    throw ParameterError("nothing to judge by: give --reference, --bag or both");
  std::vector<EstimateJudge> judges = readEstimates(options);
  if (!options.bags.empty()) insertScans(options, judges);
  printTable(judges);
  if (!options.out.empty()) writeFiles(options, judges);
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  CLI::App app{"Judges trajectories against a reference, and the maps they make", "evaluate"};
  try {
    const revisit_slam::Options options = revisit_slam::parseOptions(app, argc, argv);
    tbb::task_arena(options.threads).execute([&] { revisit_slam::run(options); });
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << "evaluate: " << error.what() << "\n";
    return 1;
  }
}
