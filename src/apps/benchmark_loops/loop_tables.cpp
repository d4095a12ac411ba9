// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <functional>

#include "loop_report.h"
#include "revisit_slam/loops/acceptance/acceptance_policy.h"
#include "revisit_slam/util/quantile.h"

namespace revisit_slam {
namespace {

using Constraints = std::vector<JudgedConstraint>;

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[512];
  std::snprintf(text, sizeof(text), pattern, values...);
  return text;
}

double quantileOrZero(const std::vector<double>& values, double share) {
  return values.empty() ? 0.0 : quantile(values, share);
}

/// "3 of 4 (75 %)"
std::string shareText(std::size_t part, std::size_t whole) {
  if (whole == 0) return "0 of 0";
  return format("%zu of %zu (%.0f %%)", part, whole,
                100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

template <typename Items, typename Condition>
std::size_t countIf(const Items& items, Condition condition) {
  return static_cast<std::size_t>(std::count_if(items.begin(), items.end(), condition));
}

bool isRight(const JudgedMap& map) {
  return map.match && map.match->is_right;
}

bool hasRightCandidate(const JudgedMap& map) {
  return std::any_of(map.candidates.begin(), map.candidates.end(),
                     [](const JudgedMatch& candidate) { return candidate.is_right; });
}

std::string mapTable(const std::vector<JudgedMap>& maps) {
  std::string text = "| closures of local maps | |\n|---|---|\n";
  const auto line = [&](const std::string& name, std::size_t part, std::size_t whole) {
    text += "| " + name + " | " + shareText(part, whole) + " |\n";
  };
  const auto is_recognised = [](const JudgedMap& map) { return map.match.has_value(); };
  const auto is_confirmed = [](const JudgedMap& map) { return map.is_confirmed; };
  const auto is_rightly_confirmed = [](const JudgedMap& map) {
    return map.is_confirmed && isRight(map);
  };
  const auto revisits = [&](auto condition) {
    return countIf(maps, [&](const JudgedMap& map) { return map.revisit && condition(map); });
  };
  const std::size_t all = revisits([](const JudgedMap&) { return true; });
  line("recognised: right", countIf(maps, isRight), countIf(maps, is_recognised));
  line("confirmed by registration: right", countIf(maps, is_rightly_confirmed),
       countIf(maps, is_confirmed));
  line("revisits with a right candidate", revisits(hasRightCandidate), all);
  line("revisits recognised rightly", revisits(isRight), all);
  line("revisits confirmed rightly", revisits(is_rightly_confirmed), all);
  for (std::size_t i = 0; i < kPassKinds; ++i) {
    const auto kind = static_cast<PassKind>(i);
    const auto of_kind = [&](const JudgedMap& map) { return map.revisit->label.kind() == kind; };
    if (revisits(of_kind) == 0) continue;
    line(std::string("— ") + toString(kind),
         revisits([&](const JudgedMap& map) { return of_kind(map) && is_rightly_confirmed(map); }),
         revisits(of_kind));
  }
  return text;
}

Constraints acceptedOf(const Constraints& constraints, LoopOrigin origin) {
  Constraints accepted;
  for (const JudgedConstraint& constraint : constraints)
    if (constraint.proposal.verdict.isAccepted() && constraint.proposal.loop.origin == origin)
      accepted.push_back(constraint);
  return accepted;
}

std::vector<double> valuesOf(const Constraints& constraints,
                             const std::function<double(const JudgedConstraint&)>& value) {
  std::vector<double> values;
  for (const JudgedConstraint& constraint : constraints) values.push_back(value(constraint));
  return values;
}

/// "3 of 4 (75 %) | 0.021 m, 0.08 deg | 0.09 m, 0.2 deg": right, median and maximum.
std::string errorColumns(const Constraints& constraints, LoopError JudgedConstraint::*error,
                         bool JudgedConstraint::*is_right) {
  const auto translations =
      valuesOf(constraints, [&](const auto& c) { return (c.*error).translation; });
  const auto rotations = valuesOf(constraints, [&](const auto& c) { return (c.*error).rotation; });
  return shareText(countIf(constraints, [&](const auto& c) { return c.*is_right; }),
                   constraints.size()) +
         format(" | %.3f m, %.2f deg | %.2f m, %.2f deg |", quantileOrZero(translations, 0.5),
                quantileOrZero(rotations, 0.5), quantileOrZero(translations, 1.0),
                quantileOrZero(rotations, 1.0));
}

std::string constraintTable(const Constraints& constraints) {
  std::string text = "| accepted constraints of submaps | right | median error | largest |\n";
  text += "|---|---|---|---|\n";
  for (const LoopOrigin origin : {LoopOrigin::appearance, LoopOrigin::retroactive}) {
    const Constraints accepted = acceptedOf(constraints, origin);
    text += std::string("| ") + toString(origin) + ", where closest | " +
            errorColumns(accepted, &JudgedConstraint::at_place, &JudgedConstraint::is_right) +
            "\n| — at the keyposes | " +
            errorColumns(accepted, &JudgedConstraint::at_keypose,
                         &JudgedConstraint::is_right_at_keypose) +
            "\n";
  }
  return text;
}

std::string outcomeTable(const Constraints& constraints) {
  std::string text = "| outcome | appearance: right, wrong | retroactive: right, wrong |\n";
  text += "|---|---|---|\n";
  std::vector<std::string> outcomes{LoopVerdict().outcome()};
  const std::vector<std::string> gates = gateNames();
  outcomes.insert(outcomes.end(), gates.begin(), gates.end());
  for (const std::string& outcome : outcomes) {
    const auto count = [&](LoopOrigin origin, bool right) {
      return countIf(constraints, [&](const JudgedConstraint& c) {
        return c.proposal.verdict.outcome() == outcome && c.proposal.loop.origin == origin &&
               c.is_right == right;
      });
    };
    text += format("| %s | %zu, %zu | %zu, %zu |\n", outcome.c_str(),
                   count(LoopOrigin::appearance, true), count(LoopOrigin::appearance, false),
                   count(LoopOrigin::retroactive, true), count(LoopOrigin::retroactive, false));
  }
  return text;
}

std::string outcomeText(const LoopVerdict& verdict) {
  return verdict.isAccepted() ? verdict.outcome() : verdict.reason();
}

/// Every proposal whose outcome and truth contradict each other.
std::string mistakeTable(const Constraints& constraints) {
  std::string text;
  for (const JudgedConstraint& c : constraints) {
    const LoopProposal& p = c.proposal;
    if (p.verdict.isAccepted() == c.is_right) continue;
    text += format("| %u (%u) | %u (%u) | %s | %s %s | %.2f m %.2f deg | %.2f m %.2f deg |",
                   p.loop.source.value, p.loop.source_map.value, p.loop.target.value,
                   p.loop.target_map.value, toString(p.loop.origin), outcomeText(p.verdict).c_str(),
                   c.state.c_str(), c.at_keypose.translation, c.at_keypose.rotation,
                   c.at_place.translation, c.at_place.rotation);
    text += format(" %.2f | %.2f | %.1f m %.1f deg | %.0f m | %.0f m %s |\n",
                   p.registered.registration.fitness, p.registered.registration.coherence,
                   p.registered.movedTranslation(), p.registered.movedRotation(), c.label.distance,
                   c.label.sharedPath(), toString(c.label.kind()));
  }
  return "| source (map) | target (map) | origin | outcome | error at the keypose | where closest "
         "| "
         "fitness | coherence | moved | distance | shared |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|\n" +
         text;
}

std::string timeTable(const std::vector<MapClosure>& maps) {
  std::string text = "| time of a local map | median | maximum |\n|---|---|---|\n";
  const auto line = [&](const char* name, double MapClosure::*member) {
    std::vector<double> values;
    for (const MapClosure& map : maps) values.push_back(map.*member);
    text += format("| %s | %.0f ms | %.0f ms |\n", name, quantileOrZero(values, 0.5),
                   quantileOrZero(values, 1.0));
  };
  line("recognition", &MapClosure::recognition_ms);
  line("registration", &MapClosure::registration_ms);
  line("retroactive search and registration", &MapClosure::retroactive_ms);
  line("CPU of all these", &MapClosure::cpu_ms);
  line("optimisation", &MapClosure::optimisation_ms);
  return text;
}

}  // namespace

std::string reportText(const Judgement& judgement, const ClosedDrive& closed) {
  return mapTable(judgement.maps) + "\n" + constraintTable(judgement.constraints) + "\n" +
         outcomeTable(judgement.constraints) + "\n" + mistakeTable(judgement.constraints) + "\n" +
         timeTable(closed.maps);
}

}  // namespace revisit_slam
