// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "loop_judgement.h"

namespace revisit_slam {

/// Tables in Markdown: closures of local maps, constraints of submaps, and what they took.
std::string reportText(const Judgement& judgement, const ClosedDrive& closed);

/// All of it, and the labels of every pair of local maps that may be matched, for other programs.
std::string reportJson(const Judgement& judgement, const ClosedDrive& closed,
                       const LoopLimits& limits);

}  // namespace revisit_slam
