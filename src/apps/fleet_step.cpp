// SPDX-License-Identifier: MIT
// One step of mapping many recordings into one map; `fleet` runs them on many machines.
#include <CLI/CLI.hpp>
#include <iostream>

#include "fleet_step/steps.h"
#include "revisit_slam/io/presets.h"
#include "revisit_slam/slam/read_config.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {

SlamConfig configOf(const StepOptions& options) {
  std::vector<std::string> warnings;
  SlamConfig config =
      readConfig({options.preset, options.parameter_file, options.settings, {}}, warnings);
  for (const std::string& warning : warnings) std::cerr << "fleet_step: " << warning << "\n";
  if (options.threads > 0)
    for (const char* threads : {"background/threads", "backend/threads"})
      assign(parametersOf(config), {{threads, std::to_string(options.threads)}});
  return config;
}

namespace {

void declareParameters(CLI::App& app, StepOptions& options) {
  app.add_option("--preset", options.preset, "parameters to start from")
      ->check(CLI::IsMember(presetNames()));
  app.add_option("--params", options.parameter_file, "YAML file of parameters");
  app.add_option("--set", options.settings, "one parameter, as group/name=value")->take_all();
  app.add_option("--threads", options.threads, "threads; results do not depend on it")
      ->check(CLI::Range(1, 64));
}

CLI::App* declareSummarise(CLI::App& app, SummariseOptions& options) {
  CLI::App* step = app.add_subcommand("summarise", "places and reduced graph of a session");
  step->add_option("session", options.session, "folder of the session")
      ->required()
      ->check(CLI::ExistingDirectory);
  step->add_option("--name", options.name, "that tells it from others")->required();
  step->add_option("--out", options.out, "file to write")->required();
  return step;
}

CLI::App* declareCandidates(CLI::App& app, CandidatesOptions& options) {
  CLI::App* step = app.add_subcommand("candidates", "places that sessions seem to share");
  step->add_option("summaries", options.summaries, "files of sessions")->required();
  step->add_option("--out", options.out, "table to write")->required();
  step->add_option("--partners", options.config.partners,
                   "sessions that a place is matched with. Raise it if sessions stay apart; lower "
                   "it if too much is registered")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  step->add_option("--shortlist", options.config.shortlist,
                   "places that are compared with each. Raise it if revisits are missed; lower it "
                   "if the search takes too long")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  step->add_option("--tables", options.config.index.tables,
                   "of the index. Raise it if revisits are missed; lower it if memory is short")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  step->add_option(
          "--usual", options.config.index.usual_bucket,
          "entries of a bucket on average. Raise it if revisits are missed; lower it if the "
          "search takes too long")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  step->add_option("--bucket", options.config.index.largest_bucket,
                   "entries of a bucket of the index that count. Raise it if revisits are missed "
                   "where hundreds of sessions meet; lower it if the search takes too long")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  step->add_option("--of", options.of, "search for the first so many sessions alone; 0: for all");
  step->add_flag("--exhaustive", options.exhaustive, "compare all places, without index");
  return step;
}

CLI::App* declareRegister(CLI::App& app, RegisterOptions& options) {
  CLI::App* step = app.add_subcommand("register", "the places that two sessions seem to share");
  step->add_option("--source", options.source, "NAME FOLDER of the later session")
      ->required()
      ->expected(2);
  step->add_option("--target", options.target, "NAME FOLDER of the earlier session")
      ->required()
      ->expected(2);
  step->add_option("--candidates", options.candidates, "table of candidates")->required();
  step->add_option("--out", options.out, "file to write")->required();
  return step;
}

CLI::App* declareSolve(CLI::App& app, SolveOptions& options) {
  CLI::App* step = app.add_subcommand("solve", "one graph of all sessions");
  step->add_option("summaries", options.summaries, "files of sessions; the map of the first stays")
      ->required();
  step->add_option("--crossings", options.crossings, "files of registered sessions");
  step->add_option("--out", options.out, "folder for keyposes and tables")->required();
  return step;
}

int run(int argc, char** argv) {
  CLI::App app{"One step of mapping many recordings into one map (see fleet)"};
  app.require_subcommand(1);
  StepOptions all;
  SummariseOptions summarising;
  CandidatesOptions finding;
  RegisterOptions registering;
  SolveOptions solving;
  CLI::App* summarise = declareSummarise(app, summarising);
  CLI::App* candidates = declareCandidates(app, finding);
  CLI::App* reg = declareRegister(app, registering);
  CLI::App* solve = declareSolve(app, solving);
  for (CLI::App* step : {candidates, reg, solve}) declareParameters(*step, all);
  CLI11_PARSE(app, argc, argv);
  if (summarise->parsed()) summariseSession(summarising);
  if (candidates->parsed()) findCandidates(finding, configOf(all));
  if (reg->parsed()) registerSessions(registering, configOf(all));
  if (solve->parsed()) solveJointly(solving, configOf(all));
  return 0;
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  revisit_slam::shareMemoryAmongThreads();
  try {
    return revisit_slam::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "fleet_step: " << error.what() << "\n";
    return 1;
  }
}
