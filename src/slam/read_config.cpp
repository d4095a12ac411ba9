// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/read_config.h"

#include "revisit_slam/io/parameter_file.h"
#include "revisit_slam/io/presets.h"
#include "revisit_slam/slam/renamed_parameters.h"

namespace revisit_slam {

SlamConfig readConfig(const ConfigSources& sources, std::vector<std::string>& warnings) {
  SlamConfig config;
  const std::vector<Parameter> parameters = parametersOf(config);
  const auto assignAll = [&](const std::vector<NamedText>& values) {
    for (const std::string& warning : assign(parameters, values, kRenamedParameters))
      warnings.push_back(warning);
  };
  if (!sources.preset.empty()) assignAll(readPreset(sources.preset));
  if (!sources.parameter_file.empty()) assignAll(readParameterFile(sources.parameter_file));
  assignAll(parseSettings(sources.settings));
  if (!sources.base_frame.empty())
    config.frames.base = sources.base_frame == "none" ? "" : sources.base_frame;
  config.frames.dropLeadingSlashes();
  return config;
}

}  // namespace revisit_slam
