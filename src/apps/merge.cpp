// SPDX-License-Identifier: MIT
// Joins sessions that have driven through the same places into one.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <set>

#include "revisit_slam/io/parameter_file.h"
#include "revisit_slam/session/map_export.h"
#include "revisit_slam/session/session_writer.h"
#include "revisit_slam/slam/renamed_parameters.h"
#include "revisit_slam/slam/session_merge.h"
#include "revisit_slam/util/process_usage.h"
#include "revisit_slam/util/progress.h"

namespace revisit_slam {
namespace {

constexpr int kSomeLeftOut = 2;  // exit status

struct Options {
  std::vector<std::string> sessions, settings;
  std::string out, parameter_file;
  int threads = 0;
  bool no_export = false, quiet = false;
};

Options parseOptions(CLI::App& app, int argc, char** argv) {
  Options options;
  app.add_option("sessions", options.sessions,
                 "folders of sessions; the map of the first that is joined keeps its place")
      ->required()
      ->expected(2, 1000)
      ->check(CLI::ExistingDirectory);
  app.add_option("--out", options.out, "folder for the session of all; made if missing")
      ->required();
  app.add_option("--params", options.parameter_file,
                 "YAML file of parameters, in the place of those of the first session");
  app.add_option("--set", options.settings, "one parameter, as group/name=value")->take_all();
  app.add_option("--threads", options.threads, "threads; results do not depend on it")
      ->check(CLI::Range(1, 64));
  app.add_flag("--no-export", options.no_export, "the session alone, no map files");
  app.add_flag("--quiet", options.quiet, "no progress, only errors and what is left out");
  app.parse(argc, argv);
  return options;
}

void requireDistinct(const std::vector<std::string>& sessions) {
  std::set<std::filesystem::path> folders;
  for (const std::string& folder : sessions)
    if (!folders.insert(std::filesystem::canonical(folder)).second)
      throw std::runtime_error("the session '" + folder + "' is given twice");
}

/// Those of the first session, as far as this software has them.
SlamConfig readConfig(const Options& options) {
  SlamConfig config;
  const std::vector<Parameter> parameters = parametersOf(config);
  assignKnown(parameters, readSessionInfo(options.sessions.front() + "/session.yaml").parameters);
  const auto assignAll = [&](const std::vector<NamedText>& values) {
    for (const std::string& warning : assign(parameters, values, kRenamedParameters))
      std::cerr << "merge: " << warning << "\n";
  };
  if (!options.parameter_file.empty()) assignAll(readParameterFile(options.parameter_file));
  assignAll(parseSettings(options.settings));
  if (options.threads > 0)
    for (const char* threads : {"background/threads", "backend/threads"})
      assign(parameters, {{threads, std::to_string(options.threads)}});
  return config;
}

std::string nameOf(const LocalMapId& map, const std::vector<KnownMap>& maps) {
  std::string folder;
  for (const KnownMap& known : maps)
    if (!(map < known.maps.front()->id)) folder = known.session.folder;
  return "local map " + std::to_string(map.value) + " of " + folder;
}

/// Sessions that are new to each other show how they belong together.
void sayCrossing(const LoopSearchResult& result, const std::vector<KnownMap>& maps,
                 Progress& progress) {
  std::size_t loops = 0;
  for (const LoopConstraint& loop : result.accepted())
    if (loop.source.session != loop.target.session) ++loops;
  if (loops == 0) return;
  progress.say(result.match ? nameOf(result.match->source, maps) + " shows the place of " +
                                  nameOf(result.match->target, maps) + ": " +
                                  std::to_string(loops) + " loop constraints"
                            : std::to_string(loops) +
                                  " loop constraints where the graph has brought "
                                  "sessions together");
}

int run(const Options& options) {
  requireDistinct(options.sessions);
  const SlamConfig config = readConfig(options);
  requireUnused(options.out);
  std::vector<std::string> notices;
  std::vector<KnownMap> maps;
  SessionId next;
  std::size_t total = 0;
  for (const std::string& folder : options.sessions) {
    maps.push_back(readKnownMap(folder, next, config.loops.recognition, notices));
    next.value += static_cast<std::uint32_t>(maps.back().numbers.size());
    if (maps.size() > 1) total += maps.back().maps.size();
  }
  Progress progress("merging", "local maps", total, options.quiet);
  for (const std::string& notice : notices) std::cerr << "merge: " << notice << "\n";
  std::size_t done = 0;
  const SessionMerge merge(config, maps, [&](const LoopSearchResult& result) {
    if (result.origin == LoopOrigin::appearance) progress.update(++done);
    sayCrossing(result, maps, progress);
  });
  progress.finish();
  for (std::size_t i = 0; i < maps.size(); ++i)
    if (!merge.isJoined(i))
      std::cerr << "merge: " << maps[i].session.folder
                << " is left out: not enough places of it were recognised in the others, or they "
                   "contradict each other\n";
  const std::size_t joined = merge.joined().size();
  if (joined < 2) {
    std::cerr << "merge: no two sessions can be joined; nothing was written\n";
    return kSomeLeftOut;
  }
  merge.write(options.out);
  notices.clear();
  const Session session = readSession(options.out, notices);
  if (!options.no_export)
    for (const std::string& notice : exportSession(session, options.out)) notices.push_back(notice);
  for (const std::string& notice : notices) std::cerr << "merge: " << notice << "\n";
  return joined == maps.size() ? 0 : kSomeLeftOut;
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  revisit_slam::shareMemoryAmongThreads();
  CLI::App app{
      "Joins sessions that have driven through the same places into one. Exit status 2: some, or "
      "all, cannot be joined and are left out"};
  try {
    return revisit_slam::run(revisit_slam::parseOptions(app, argc, argv));
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << "merge: " << error.what() << "\n";
    return 1;
  }
}
