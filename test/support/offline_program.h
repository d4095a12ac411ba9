// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/child_process.h"

namespace revisit_slam {

/// One run of the offline program over a bag. The results go when the object does.
class OfflineProgram {
 public:
  explicit OfflineProgram(const std::string& bag, const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments{REVISIT_SLAM_OFFLINE_PROGRAM, "--bag", bag, "--out",
                                       results("")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    ChildProcess process(arguments);
    status = process.wait(300.0);
    output = process.output();
  }

  std::string results(const std::string& name) const { return folder_.file("results/" + name); }
  nlohmann::json summary() const { return nlohmann::json::parse(textOf(results("run.json"))); }

  int status = 0;
  std::string output;

 private:
  TemporaryFolder folder_;
};

}  // namespace revisit_slam
