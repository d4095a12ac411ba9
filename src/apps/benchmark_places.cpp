// SPDX-License-Identifier: MIT
// What recognising a place costs against ever more stored local maps.
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <random>

#include "revisit_slam/io/pcd.h"
#include "revisit_slam/loops/recognition/place_recognition.h"
#include "revisit_slam/util/process_usage.h"

namespace revisit_slam {
namespace {

struct Options {
  std::string maps;
  int stored = 1000, report_every = 250, threads = 2;
};

std::vector<Points> readMaps(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".pcd") paths.push_back(entry.path().string());
  if (paths.empty()) throw std::runtime_error("no *.pcd in " + folder);
  std::sort(paths.begin(), paths.end());
  std::vector<Points> maps;
  for (const std::string& path : paths) maps.push_back(readPcdPoints(path));
  return maps;
}

/// Another place of the same kind: turned, every other one mirrored, and with a quarter of its
/// blocks of 10 m missing.
Points variant(const Points& points, std::uint32_t number) {
  std::minstd_rand random(number + 1);
  const float mirror = number % 2 == 0 ? 1.0f : -1.0f;
  const Eigen::Matrix3f R =
      Eigen::AngleAxisf(static_cast<float>(random() % 628) * 0.01f, Eigen::Vector3f::UnitZ())
          .toRotationMatrix();
  const std::uint32_t salt = static_cast<std::uint32_t>(random());
  Points result;
  for (const Eigen::Vector3f& point : points) {
    const auto block = [](float x) { return static_cast<std::uint32_t>(std::lround(0.1f * x)); };
    const std::uint32_t hash =
        (block(point.x()) * 73856093u ^ block(point.y()) * 19349663u ^ salt) * 2654435761u;
    if (hash >> 30 == 0) continue;
    result.push_back(R * Eigen::Vector3f(point.x(), mirror * point.y(), point.z()));
  }
  return result;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void run(const Options& options) {
  const std::vector<Points> maps = readMaps(options.maps);
  std::printf("%zu different maps, %d threads\n\n", maps.size(), options.threads);
  std::printf(
      "| stored maps | wall, median [ms] | largest [ms] | CPU, mean [ms] | memory [MB] |\n"
      "|---:|---:|---:|---:|---:|\n");
  PlaceRecognition recognition{PlaceRecognitionConfig{}};
  tbb::task_arena arena(options.threads);
  constexpr int kMeasured = 40;  // before each line
  std::vector<double> wall_ms;
  double cpu_seconds = 0.0;
  for (int stored = 0; stored < options.stored; ++stored) {
    const auto number = static_cast<std::uint32_t>(stored);
    const LocalMap map{{number}, {}, variant(maps[number % maps.size()], number)};
    const double cpu_before = processCpuSeconds();
    const auto start = std::chrono::steady_clock::now();
    arena.execute([&] { recognition.recognise(map); });
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    if (options.report_every - stored % options.report_every <= kMeasured) {
      wall_ms.push_back(wall.count());
      cpu_seconds += processCpuSeconds() - cpu_before;
    }
    if ((stored + 1) % options.report_every != 0) continue;
    std::printf("| %d | %.1f | %.1f | %.1f | %.1f |\n", stored + 1, median(wall_ms),
                *std::max_element(wall_ms.begin(), wall_ms.end()),
                1e3 * cpu_seconds / static_cast<double>(wall_ms.size()),
                1e-6 * static_cast<double>(recognition.bytes()));
    std::fflush(stdout);
    wall_ms.clear();
    cpu_seconds = 0.0;
  }
}

}  // namespace
}  // namespace revisit_slam

int main(int argc, char** argv) {
  CLI::App app{"Cost of place recognition against the number of stored local maps"};
  revisit_slam::Options options;
  app.add_option("--maps", options.maps,
                 "folder of local maps (*.pcd) as benchmark_loops leaves them")
      ->required();
  app.add_option("--stored", options.stored, "local maps, made out of those by variation")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--report-every", options.report_every, "maps between two lines")
      ->check(CLI::Range(50, 1000000));
  app.add_option("--threads", options.threads, "threads")->check(CLI::Range(1, 64));
  CLI11_PARSE(app, argc, argv);
  try {
    revisit_slam::run(options);
  } catch (const std::exception& error) {
    std::cerr << "benchmark_places: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
