// SPDX-License-Identifier: MIT
// How many loops of a drive with known truth are closed, how rightly, and what that takes.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "benchmark_loops/loop_report.h"
#include "revisit_slam/io/pcd.h"
#include "revisit_slam/io/whole_file.h"
#include "revisit_slam/slam/renamed_parameters.h"

namespace revisit_slam {
namespace {

struct Options {
  std::string bag, topic, truth, out;
  std::vector<std::string> settings;
  int threads = 1;
  bool quiet = false;
  LoopLimits limits;
};

SlamConfig readConfig(const Options& options) {
  SlamConfig config;
  const std::vector<Parameter> parameters = parametersOf(config);
  for (const std::string& warning :
       assign(parameters, parseSettings(options.settings), kRenamedParameters))
    std::cerr << "benchmark_loops: " << warning << "\n";
  for (const char* threads : {"odometry/threads", "background/threads", "backend/threads"})
    assign(parameters, {{threads, std::to_string(options.threads)}});
  return config;
}

/// The points of each local map in its own frame, NNNNNN.pcd: the same input for other programs.
void writeMaps(const std::string& folder, const std::vector<MapClosure>& closures) {
  std::filesystem::create_directories(folder);
  for (const MapClosure& closure : closures) {
    const LocalMap& map = *closure.search.map;
    char name[32];
    std::snprintf(name, sizeof(name), "/%06u.pcd", map.id.value);
    writePcd(folder + name, map.points);
  }
}

void run(const Options& options) {
  const SlamConfig config = readConfig(options);
  const PoseInterpolator truth(readTum(options.truth));
  const ClosedDrive closed = closeLoops(options.bag, options.topic, config, options.quiet);
  const Judgement judgement =
      judge(closed, truth, static_cast<std::size_t>(config.loops.recognition.newest_excluded),
            options.limits);
  std::cout << reportText(judgement, closed);
  if (options.out.empty()) return;
  writeMaps(options.out + "/maps", closed.maps);
  writeTum(options.out + "/odometry.tum", closed.odometry);
  writeTum(options.out + "/trajectory.tum", closed.trajectory);
  writeWholeText(options.out + "/loops.json", reportJson(judgement, closed, options.limits));
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  CLI::App app{"Loop closure of a drive judged by its true trajectory"};
  revisit_slam::Options options;
  app.add_option("--bag", options.bag, "bag file")->required();
  app.add_option("--points,--topic", options.topic,
                 "topic of the scans; may be left out when there is one");
  app.add_option("--truth", options.truth, "TUM file of the base's true poses")->required();
  app.add_option("--out", options.out, "folder for loops.json and the local maps; made if missing");
  app.add_option("--set", options.settings, "one parameter, as group/name=value")->take_all();
  app.add_option("--threads", options.threads, "threads; results do not depend on it")
      ->check(CLI::Range(1, 64));
  app.add_flag("--quiet", options.quiet, "no progress");
  CLI11_PARSE(app, argc, argv);
  try {
    revisit_slam::run(options);
  } catch (const std::exception& error) {
    std::cerr << "benchmark_loops: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
