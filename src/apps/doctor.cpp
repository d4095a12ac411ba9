// SPDX-License-Identifier: MIT
// Looks at a recording, or at what is live, and says for each fault what to do.
#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "doctor/checks.h"
#include "revisit_slam/io/presets.h"
#include "revisit_slam/slam/read_config.h"

namespace revisit_slam {
namespace {

struct Options {
  Patient patient;
  ConfigSources config;
  std::string mode = "live";
};

void addOptions(CLI::App& app, Options& options) {
  Patient& patient = options.patient;
  app.add_option("mode", options.mode,
                 "live: look at what is published now, as without --bag; manager: only whether "
                 "--manager runs")
      ->check(CLI::IsMember({"live", "manager"}));
  app.add_option("--bag", patient.bags, "bag file; several are read in the order of time");
  app.add_option("--points", patient.points,
                 "topic of the scans; may be left out when there is one");
  app.add_option("--base-frame", options.config.base_frame,
                 "frame whose pose is estimated, as frames/base; none: the sensor's own");
  app.add_option("--folder", patient.folder, "folder in which maps are to be written");
  app.add_option("--manager", patient.manager, "nodelet manager that the nodelets are to be in");
  app.add_option("--seconds", patient.seconds, "time to listen to a live topic")
      ->check(CLI::Range(0.0, 3600.0));
  app.add_option("--max-scans", patient.max_scans, "of a bag that are looked at");
  app.add_option("--preset", options.config.preset, "parameters to start from")
      ->check(CLI::IsMember(presetNames()));
  app.add_option("--params", options.config.parameter_file, "YAML file of parameters");
  app.add_option("--set", options.config.settings, "one parameter, as group/name=value")
      ->take_all();
}

const char* nameOf(Finding::Level level) {
  switch (level) {
    case Finding::Level::good:
      return "ok";
    case Finding::Level::hint:
      return "hint";
    case Finding::Level::warning:
      return "WARNING";
    case Finding::Level::fault:
      return "FAULT";
  }
  return "";
}

void print(const Finding& finding) {
  std::printf("%-8s %-15s %s\n", nameOf(finding.level), finding.part.c_str(), finding.text.c_str());
  if (!finding.remedy.empty()) std::printf("%-8s   -> %s\n", "", finding.remedy.c_str());
}

/// @return exit status: whether there was a fault.
int report(const Diagnosis& diagnosis) {
  std::size_t faults = 0, warnings = 0;
  for (const Finding& finding : diagnosis.findings) {
    print(finding);
    faults += finding.level == Finding::Level::fault ? 1 : 0;
    warnings += finding.level == Finding::Level::warning ? 1 : 0;
  }
  std::printf("\n%zu faults, %zu warnings.\n", faults, warnings);
  if (faults == 0 && !diagnosis.command.empty())
    std::printf("Map it with: %s\n", diagnosis.command.c_str());
  return faults > 0 ? 1 : 0;
}

/// It may still be starting.
Diagnosis awaitManager(const Patient& patient) {
  ros::NodeHandle node;
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(patient.seconds);
  Finding finding = checkManager(patient.manager);
  while (finding.level != Finding::Level::good && ros::ok() && ros::WallTime::now() < end) {
    ros::WallDuration(0.2).sleep();
    finding = checkManager(patient.manager);
  }
  return {{finding}, ""};
}

Diagnosis examine(Options& options) {
  if (options.mode == "manager") return awaitManager(options.patient);
  std::vector<std::string> warnings;
  options.patient.config = readConfig(options.config, warnings);
  for (const std::string& warning : warnings) std::cerr << "doctor: " << warning << "\n";
  Diagnosis diagnosis =
      options.patient.bags.empty() ? checkLive(options.patient) : checkBags(options.patient);
  if (!options.patient.folder.empty())
    diagnosis.findings.push_back(checkFolder(options.patient.folder));
  return diagnosis;
}

int run(int argc, char** argv) {
  CLI::App app{"Looks at a recording, or at what is live, and says for each fault what to do"};
  Options options;
  addOptions(app, options);
  ros::init(argc, argv, "doctor", ros::init_options::AnonymousName | ros::init_options::NoRosout);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  return report(examine(options));
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  try {
    return revisit_slam::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "doctor: %s\n", error.what());
    return 1;
  }
}
