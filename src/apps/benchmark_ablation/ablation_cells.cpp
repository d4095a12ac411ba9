// SPDX-License-Identifier: MIT
#include "ablation_cells.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/io/presets.h"

namespace revisit_slam {
namespace {

using Names = std::vector<std::string>;

const Names kKernels{"none", "huber", "cauchy", "geman_mcclure"};

/// The values of the preset `paper` in these groups.
void takeFromPaper(const Names& groups, SlamConfig& config) {
  std::vector<NamedText> values;
  for (const NamedText& value : readPreset("paper"))
    if (std::find(groups.begin(), groups.end(), value.first.substr(0, value.first.find('/'))) !=
        groups.end())
      values.push_back(value);
  assign(parametersOf(config), values);
}

/// With the parameters that its words stand for.
AblationCell configured(AblationCell cell) {
  if (cell.odometry == "paper") takeFromPaper({"odometry", "information", "mapping"}, cell.config);
  if (cell.loops == "paper") takeFromPaper({"loops", "retroactive", "backend"}, cell.config);
  cell.config.information.enabled = cell.information == "sampled";
  cell.config.retroactive.enabled = cell.retroactive == "on";
  cell.config.backend.loop_kernel.kernel = cell.kernel;
  if (cell.kernel_scale > 0.0) cell.config.backend.loop_kernel.kernel_scale = cell.kernel_scale;
  cell.kernel_scale = cell.config.backend.loop_kernel.kernel_scale;
  return cell;
}

}  // namespace

std::vector<AblationCell> cellsOf(const std::string& odometry) {
  std::vector<AblationCell> cells;
  for (const char* information : {"sampled", "identity"})
    for (const char* loops : {"ours", "paper"})
      for (const char* retroactive : {"on", "off"})
        for (const std::string& kernel : kKernels)
          cells.push_back(configured({odometry, information, loops, retroactive, kernel, 0.0, {}}));
  return cells;
}

std::vector<AblationCell> kernelScalesOf(const std::string& odometry) {
  std::vector<AblationCell> cells;
  for (const std::string& kernel : kKernels)
    for (int half_decade = -2; half_decade <= 6 && kernel != "none"; ++half_decade)
      cells.push_back(configured(
          {odometry, "sampled", "ours", "on", kernel, std::pow(10.0, 0.5 * half_decade), {}}));
  return cells;
}

SlamConfig frontEndOf(const std::string& odometry) {
  SlamConfig config = configured({odometry, "sampled", "ours", "on", "none", 0.0, {}}).config;
  config.loops.enabled = false;
  config.occupancy.enabled = false;
  return config;
}

}  // namespace revisit_slam
