// SPDX-License-Identifier: MIT
// Makes maps and tables of a session, whether it was closed, is being driven, or was killed.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "revisit_slam/io/cloud_file.h"
#include "revisit_slam/io/folder_lock.h"
#include "revisit_slam/session/keyposes.h"
#include "revisit_slam/session/map_export.h"
#include "revisit_slam/session/session_writer.h"
#include "revisit_slam/util/process_usage.h"
#include "revisit_slam/util/progress.h"

namespace revisit_slam {
namespace {

struct Options {
  std::string session, out, keyposes, frame = "map";
  std::vector<std::string> formats{"pcd"};
  double resolution = 0.0, tile = 0.0;
  int utm_zone = 0;
  bool no_submaps = false, no_graph = false, no_occupancy = false, force = false, quiet = false;
  bool only_static = false;
};

Options parseOptions(CLI::App& app, int argc, char** argv) {
  Options options;
  app.add_option("session", options.session, "folder of the session")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--out", options.out, "folder for the files; default: the session's");
  app.add_option("--format", options.formats, "formats of the map's cloud: pcd, ply, las; none")
      ->delimiter(',');
  app.add_option("--map-resolution", options.resolution,
                 "m, one point for each voxel of this edge; default: as finely as stored")
      ->check(CLI::PositiveNumber);
  app.add_option("--tile", options.tile, "m, cut the cloud into squares of this edge")
      ->check(CLI::Range(1.0, 1e6));
  app.add_option("--frame", options.frame,
                 "frame of the map's cloud: map, or with GNSS enu (east, north, up) or utm (las)");
  app.add_option("--utm-zone", options.utm_zone, "zone of --frame utm; default: of the datum")
      ->check(CLI::Range(1, 60));
  app.add_option("--keyposes", options.keyposes,
                 "file that says where the submaps are in the map of many sessions (fleet)")
      ->check(CLI::ExistingFile);
  app.add_flag("--static", options.only_static,
               "points of what moved go to map_dynamic.* instead, and out of OctoMap and grid");
  app.add_flag("--no-submaps", options.no_submaps, "no clouds of single submaps");
  app.add_flag("--no-graph", options.no_graph, "no trajectories, no pose graph, no tables");
  app.add_flag("--no-occupancy", options.no_occupancy, "no OctoMap, no grid");
  app.add_flag("--force", options.force, "replace files that are in --out already");
  app.add_flag("--quiet", options.quiet, "no progress, only errors and what could not be used");
  app.parse(argc, argv);
  return options;
}

ExportConfig configOf(const Options& options) {
  ExportConfig config;
  config.clouds = {options.formats.begin(), options.formats.end()};
  config.clouds.erase("none");
  for (const std::string& format : config.clouds) requireCloudFormat(format);
  config.frame.kind = mapFrameKind(options.frame);
  if (options.utm_zone > 0) config.frame.utm_zone = options.utm_zone;
  config.graph = !options.no_graph;
  config.submaps = !options.no_submaps;
  config.occupancy = !options.no_occupancy;
  config.remove_dynamic = options.only_static;
  if (options.resolution > 0.0) config.resolution = options.resolution;
  if (options.tile > 0.0) config.tile = options.tile;
  return config;
}

/// What is in the session's own folder is the session's; elsewhere it may be anybody's.
void requireRoom(const Options& options) {
  if (options.out.empty() || options.force) return;
  std::error_code ignored;
  if (std::filesystem::equivalent(options.session, options.out, ignored)) return;
  requireUnused(options.out);
}

int run(const Options& options) {
  const ExportConfig config = configOf(options);
  requireRoom(options);
  std::vector<std::string> notices;
  Session session = readSession(options.session, notices);
  if (!options.keyposes.empty()) moveToKeyposes(readKeyposes(options.keyposes), session);
  constexpr std::size_t steps = 1000;
  Progress progress("exporting", "per mille", steps, options.quiet);
  const bool is_driven = isLocked(options.session);
  progress.say(std::to_string(session.submaps.size()) + " submaps, " +
               std::to_string(session.graph.nodes.size()) + " scans, " +
               std::to_string(session.graph.loops.size()) + " loops; " +
               (session.info.closed ? "closed"
                : is_driven         ? "is being driven: up to the last submap that is closed"
                                    : "not closed: up to the last submap that was"));
  const std::string out = options.out.empty() ? options.session : options.out;
  for (const std::string& notice : exportSession(session, out, config, [&](double share) {
         progress.update(static_cast<std::size_t>(share * steps));
       }))
    notices.push_back(notice);
  progress.finish();
  for (const std::string& notice : notices) std::cerr << "export: " << notice << "\n";
  return 0;
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  revisit_slam::shareMemoryAmongThreads();
  CLI::App app{"Makes trajectories, pose graph, map and occupancy of a session"};
  try {
    return revisit_slam::run(revisit_slam::parseOptions(app, argc, argv));
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << "export: " << error.what() << "\n";
    return 1;
  }
}
