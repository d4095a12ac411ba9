// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "loop_report.h"

namespace revisit_slam {
namespace {

using nlohmann::json;

json poseJson(const Pose& T) {
  const Eigen::Matrix4d matrix = T.matrix();
  json rows = json::array();
  for (int row = 0; row < 4; ++row)
    rows.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
  return rows;
}

json errorJson(const LoopError& error) {
  return {{"translation", error.translation}, {"rotation", error.rotation}};
}

json pairJson(const LabelledPair& pair) {
  const LoopLabel& label = pair.label;
  return {{"target", pair.target.value},
          {"T_target_source", poseJson(label.T_target_source)},
          {"closest_source",
           {label.closest_source.x(), label.closest_source.y(), label.closest_source.z()}},
          {"distance", label.distance},
          {"shared", label.sharedPath()},
          {"kind", toString(label.kind())},
          {"is_revisit", label.isRevisit()}};
}

json matchJson(const JudgedMatch& judged) {
  return {{"target", judged.match.target.value}, {"inliers", judged.match.inliers},
          {"matches", judged.match.matches},     {"rms", judged.match.rms},
          {"error", errorJson(judged.error)},    {"is_right", judged.is_right}};
}

json mapJson(const JudgedMap& map, const MapClosure& closure) {
  json text = {{"id", map.id.value},
               {"length", map.length},
               {"points", closure.search.map->points.size()},
               {"features", closure.search.view ? closure.search.view->features.size() : 0},
               {"is_confirmed", map.is_confirmed},
               {"earlier", json::array()},
               {"candidates", json::array()},
               {"cpu_ms", closure.cpu_ms},
               {"recognition_ms", closure.recognition_ms},
               {"registration_ms", closure.registration_ms},
               {"retroactive_ms", closure.retroactive_ms},
               {"optimisation_ms", closure.optimisation_ms}};
  for (const LabelledPair& pair : map.earlier) text["earlier"].push_back(pairJson(pair));
  for (const JudgedMatch& candidate : map.candidates)
    text["candidates"].push_back(matchJson(candidate));
  if (map.revisit) text["revisit"] = map.revisit->target.value;
  if (map.match) text["match"] = matchJson(*map.match);
  return text;
}

/// By which gate and why; null if accepted.
json rejectionJson(const LoopVerdict& verdict) {
  if (verdict.isAccepted()) return nullptr;
  const GateMeasurement& measurement = verdict.measurement;
  return {{"gate", verdict.gate},
          {"value", measurement.value},
          {"limit", measurement.limit},
          {"unit", measurement.unit}};
}

json constraintJson(const JudgedConstraint& c) {
  const LoopProposal& p = c.proposal;
  const FineRegistrationResult& registration = p.registered.registration;
  return {{"source", p.loop.source.value},
          {"target", p.loop.target.value},
          {"source_map", p.loop.source_map.value},
          {"target_map", p.loop.target_map.value},
          {"origin", toString(p.loop.origin)},
          {"outcome", p.verdict.outcome()},
          {"rejected", rejectionJson(p.verdict)},
          {"state", c.state},
          {"is_right", c.is_right},
          {"is_right_at_keypose", c.is_right_at_keypose},
          {"error_at_keypose", errorJson(c.at_keypose)},
          {"error_at_place", errorJson(c.at_place)},
          {"distance", c.label.distance},
          {"shared", c.label.sharedPath()},
          {"kind", toString(c.label.kind())},
          {"fitness", registration.fitness},
          {"coherence", registration.coherence},
          {"rms", registration.rms},
          {"inliers", registration.inliers},
          {"iterations", registration.iterations},
          {"hausdorff", p.hausdorff},
          {"overlap", p.overlap},
          {"drift", p.registered.prior.drift.plane},
          {"deviation", p.registered.deviation(DriftConfig())},
          {"ambiguity", p.registered.ambiguity(LoopCloserConfig().max_translation)},
          {"moved",
           {{"translation", p.registered.movedTranslation()},
            {"rotation", p.registered.movedRotation()}}}};
}

}  // namespace

std::string reportJson(const Judgement& judgement, const ClosedDrive& closed,
                       const LoopLimits& limits) {
  json text = {{"limits",
                {{"map_translation", limits.map_translation},
                 {"map_rotation", limits.map_rotation},
                 {"constraint_translation", limits.constraint_translation},
                 {"constraint_rotation", limits.constraint_rotation}}},
               {"maps", json::array()},
               {"constraints", json::array()}};
  for (std::size_t i = 0; i < judgement.maps.size(); ++i)
    text["maps"].push_back(mapJson(judgement.maps[i], closed.maps[i]));
  for (const JudgedConstraint& c : judgement.constraints)
    text["constraints"].push_back(constraintJson(c));
  return text.dump(1) + "\n";
}

}  // namespace revisit_slam
