// SPDX-License-Identifier: MIT
// Maps a recorded drive without a ROS master, as fast as the machine allows.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "offline/offline_run.h"
#include "revisit_slam/datasets/open_dataset.h"
#include "revisit_slam/io/presets.h"
#include "revisit_slam/priors/motion_priors.h"
#include "revisit_slam/slam/map_to_extend.h"
#include "revisit_slam/slam/read_config.h"
#include "revisit_slam/util/interruption.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {
namespace {

struct Options {
  std::vector<std::string> bags, dataset;
  std::string topic, out;
  ConfigSources config;
  std::string map, mode = "map";
  OfflineExtent extent;
  int threads = 0;
  bool quiet = false;
};

SlamConfig configOf(const Options& options) {
  std::vector<std::string> warnings;
  SlamConfig config = readConfig(options.config, warnings);
  for (const std::string& warning : warnings) std::cerr << "offline: " << warning << "\n";
  const std::vector<Parameter> parameters = parametersOf(config);
  if (options.mode == "localize") assign(parameters, {{"localization/map", options.map}});
  if (options.threads > 0)
    for (const char* threads : {"odometry/threads", "background/threads", "backend/threads"})
      assign(parameters, {{threads, std::to_string(options.threads)}});
  return config;
}

/// What the drive goes on from, if it extends a map.
KnownMapPtr readPrior(const Options& options, const SlamConfig& config) {
  if (options.mode != "extend") return nullptr;
  std::vector<std::string> notices;
  KnownMapPtr prior = readMapToExtend(options.map, config.loops.recognition, notices);
  for (const std::string& notice : notices) std::cerr << "offline: " << notice << "\n";
  return prior;
}

/// Those of several sensors, or the one of the command line.
std::string topicsOf(const Options& options, const SlamConfig& config) {
  if (config.input.topics.empty()) return options.topic;
  if (!options.topic.empty())
    throw ParameterError("--points and input/topics both name topics: give one of them");
  return config.input.topics;
}

std::unique_ptr<ScanSource> openSource(const Options& options, const SlamConfig& config) {
  if (options.dataset.empty())
    return openBags(options.bags, topicsOf(options, config), config.priors, config.gnss);
  if (MotionPriors(config.priors).isConnected() || config.gnss.isConnected() ||
      !config.input.topics.empty())
    throw ParameterError(
        "input/topics, priors/…_topic, priors/odometry_frame and gnss/topic name topics of bags: "
        "datasets "
        "have none");
  return openDatasetSource(options.dataset.front(), options.dataset.back());
}

Options parseOptions(CLI::App& app, int argc, char** argv) {
  Options options;
  app.add_option("--bag", options.bags, "bag file; several are read in the order of time");
  app.add_option("--dataset", options.dataset, "NAME DIR: a sequence of a public dataset")
      ->expected(2);
  app.add_option("--points,--topic", options.topic,
                 "topic of the scans; may be left out when there is one");
  app.add_option("--base-frame", options.config.base_frame,
                 "frame whose pose is estimated, as frames/base; none: the sensor's own");
  app.add_option("--out", options.out, "folder for the results; made if missing")->required();
  app.add_option("--preset", options.config.preset,
                 "parameters to start from, before --params and --set")
      ->check(CLI::IsMember(presetNames()));
  app.add_option("--params", options.config.parameter_file, "YAML file of parameters");
  app.add_option("--set", options.config.settings, "one parameter, as group/name=value")
      ->take_all();
  app.add_option("--threads", options.threads, "threads; results do not depend on it")
      ->check(CLI::Range(1, 64));
  app.add_option("--map", options.map, "session whose map to localize in, or to extend");
  app.add_option("--mode", options.mode,
                 "map: make a new map; localize: find the drive in the map of --map; extend: map "
                 "the drive, and join it to that map, which is copied to --out")
      ->check(CLI::IsMember({"map", "localize", "extend"}));
  app.add_option("--first-scan", options.extent.first_scan, "leave out so many scans before");
  app.add_option("--max-scans", options.extent.max_scans, "stop after so many scans");
  app.add_flag("--quiet", options.quiet, "no progress, only errors");
  app.parse(argc, argv);
  if (options.bags.empty() == options.dataset.empty())
    throw CLI::ValidationError("scans", "give either --bag or --dataset");
  if ((options.mode == "map") != options.map.empty())
    throw CLI::ValidationError("mode",
                               "--map SESSION and --mode localize or extend belong together");
  return options;
}

/// What was mapped before something went wrong is not lost.
void sayHowToGoOn(const std::string& folder) {
  if (std::filesystem::exists(folder + "/graph.log"))
    std::cerr << "offline: this makes the map of what is in the folder: rosrun revisit_slam export "
              << folder << "\n";
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  revisit_slam::shareMemoryAmongThreads();
  revisit_slam::catchInterruption();
  revisit_slam::Options options;
  bool has_begun = false;
  CLI::App app{"Maps a recorded drive; the results are files in a folder"};
  try {
    options = revisit_slam::parseOptions(app, argc, argv);
    const revisit_slam::SlamConfig config = revisit_slam::configOf(options);
    revisit_slam::OfflineRun run(config, revisit_slam::openSource(options, config), options.out,
                                 options.extent, options.quiet,
                                 revisit_slam::readPrior(options, config));
    has_begun = true;
    run.run();
    return revisit_slam::interruption() != 0 ? 128 + revisit_slam::interruption() : 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << "offline: " << error.what() << "\n";
    if (has_begun) revisit_slam::sayHowToGoOn(options.out);
    return 1;
  }
}
