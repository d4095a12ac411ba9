// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "revisit_slam/simulation/report.h"
#include "simulate/drive_bag.h"

namespace revisit_slam::simulation {
namespace {

std::string besides(const std::string& bag, const std::string& ending) {
  const bool named_bag = bag.size() > 4 && bag.compare(bag.size() - 4, 4, ".bag") == 0;
  return (named_bag ? bag.substr(0, bag.size() - 4) : bag) + ending;
}

std::vector<Revisit> revisitsUntil(const Route& route, Stamp end) {
  std::vector<Revisit> seen;
  for (Revisit revisit : findRevisits(route)) {
    if (revisit.later_from > end) continue;
    revisit.later_until = std::min(revisit.later_until, end);
    seen.push_back(revisit);
  }
  return seen;
}

DriveReport reportOf(const Options& o, const Route& route, const World& world,
                     const Summary& summary) {
  DriveReport report;
  report.options = namedOptions(o);
  report.scans = static_cast<int>(summary.last_points.size());
  report.points = summary.points;
  report.start = route.start();
  report.end = summary.last_points.empty() ? route.start() : summary.last_points.back();
  report.length = route.arcAt(report.end);
  report.triangles = world.still.triangles.size();
  report.moving_cars = world.cars.size();
  report.people = world.people.size();
  report.revisits = revisitsUntil(route, report.end);
  return report;
}

void run(Options o) {
  complete(o);
  const Route route = makeRoute(o.route);
  const World world = makeWorld(o.traffic, worldRoute(o.route), route);
  const ScanSimulator simulator(world, route, makeSensor(o.sensor, o.columns), o.scan);
  const int count = scanCount(route, o.max_scans);
  if (!o.quiet) {
    std::fprintf(stderr,
                 "%s: %.0f m, %.1f s, %d scans, %zu triangles, %zu moving cars, %zu people\n",
                 o.world.c_str(), route.length(), secondsBetween(route.start(), route.end()), count,
                 world.still.triangles.size(), world.cars.size(), world.people.size());
  }
  const Summary summary = writeBag(o, world, route, simulator, count);
  writeTruth(besides(o.out, ".gt.tum"), route, summary.last_points);
  writeReport(besides(o.out, ".json"), reportOf(o, route, world, summary));
}

}  // namespace
}  // namespace revisit_slam::simulation

int main(int argc, char** argv) {
  CLI::App app("Simulates a LiDAR drive and writes it as a ROS bag with its true trajectory.",
               "simulate");
  revisit_slam::simulation::Options options;
  revisit_slam::simulation::declareOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    revisit_slam::simulation::run(options);
  } catch (const std::exception& error) {
    std::cerr << "simulate: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
