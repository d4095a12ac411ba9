// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/gnss_factors.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "revisit_slam/pose_graph/enu_alignment.h"
#include "revisit_slam/pose_graph/graph_cost.h"

namespace revisit_slam {
namespace {

/// Of a base whose tilt is known to `deviation` where nothing else is: the map's z axis is that of
/// the first scan's base.
RelativePoseFactor uprightStart(NodeId enu, const Pose& T_map_enu, double deviation) {
  RelativePoseFactor upright{{NodeId{0}, enu}, T_map_enu, Matrix6::Zero()};
  upright.T_from_to.rotation = expSO3({0.0, 0.0, logSO3(T_map_enu.rotation).z()});
  upright.information.diagonal().segment<2>(3).setConstant(1.0 / (deviation * deviation));
  return upright;
}

constexpr double kFarFromOrigin = 1e4;  // m: the frame enu would no longer be upright there

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

GnssFactors::GnssFactors(const GnssConfig& config)
    : config_(config), given_datum_(config.givenDatum()) {}

void GnssFactors::add(std::size_t node, const std::vector<GnssFix>& fixes, std::size_t first) {
  for (const GnssFix& fix : fixes) {
    if (!enu_) enu_.emplace(fix.position);
    const NodeId scan{static_cast<std::uint32_t>(first) + fix.scan.value};
    fixes_.push_back({node, scan, fix, enu_->toEnu(fix.position), fix.covariance_enu.inverse()});
  }
}

std::vector<const GnssFactors::Tied*> GnssFactors::fixesOf(std::size_t nodes,
                                                           const IsInMap& is_in_map) const {
  std::vector<const Tied*> fixes;
  for (std::size_t i = 0; i < countOf(nodes); ++i)
    if (is_in_map(fixes_[i].scan)) fixes.push_back(&fixes_[i]);
  return fixes;
}

/// At the first position, unless that is far from most. A receiver may say 0, 0 first.
void GnssFactors::placeOrigin(std::size_t nodes, const IsInMap& is_in_map) {
  const std::vector<const Tied*> fixes = fixesOf(nodes, is_in_map);
  if (T_map_enu_ || fixes.empty()) return;
  std::vector<double> latitudes, longitudes, altitudes;
  for (const Tied* tied : fixes) {
    latitudes.push_back(tied->fix.position.latitude);
    longitudes.push_back(tied->fix.position.longitude);
    altitudes.push_back(tied->fix.position.altitude);
  }
  const GeodeticPosition middle{medianOf(std::move(latitudes)), medianOf(std::move(longitudes)),
                                medianOf(std::move(altitudes))};
  if (enu_->toEnu(middle).norm() < kFarFromOrigin) return;
  enu_.emplace(middle);
  for (Tied& tied : fixes_) tied.p_enu = enu_->toEnu(tied.fix.position);
}

std::size_t GnssFactors::countOf(std::size_t nodes) const {
  const auto end = std::partition_point(fixes_.begin(), fixes_.end(),
                                        [&](const Tied& tied) { return tied.node < nodes; });
  return static_cast<std::size_t>(end - fixes_.begin());
}

RelativePositionFactor GnssFactors::factorOf(const Tied& tied, NodeId enu) const {
  return {{enu, tied.scan}, tied.fix.p_scan, tied.p_enu, tied.information};
}

/// By the positions alone, or as the last solution left it: whichever fits better.
std::optional<Pose> GnssFactors::bestStart(const PoseGraph& graph,
                                           const std::vector<const Tied*>& fixes,
                                           double& deviation) const {
  std::vector<PositionPair> pairs;
  for (const Tied* tied : fixes) {
    const Eigen::Matrix3d& covariance = tied->fix.covariance_enu;
    pairs.push_back({graph.poses()[tied->scan.value] * tied->fix.p_scan, tied->p_enu,
                     std::sqrt(0.5 * covariance.topLeftCorner<2, 2>().trace()),
                     std::sqrt(covariance(2, 2))});
  }
  const std::optional<EnuAlignment> aligned = alignToEnu(pairs, config_.kernel_scale);
  if (!aligned || aligned->yaw_deviation > config_.alignment_deviation) return T_map_enu_;
  deviation = aligned->yaw_deviation;
  const auto costOf = [&](const Pose& T_map_enu) {
    double cost = 0.0;
    for (const PositionPair& pair : pairs) {
      const Eigen::Vector3d e = T_map_enu * pair.p_enu - pair.p_map;
      const double chi2 = e.head<2>().squaredNorm() / (pair.deviation * pair.deviation);
      cost += std::log1p(chi2 / (config_.kernel_scale * config_.kernel_scale));
    }
    return cost;
  };
  const bool stays = T_map_enu_ && costOf(*T_map_enu_) <= costOf(aligned->T_map_enu);
  return stays ? *T_map_enu_ : aligned->T_map_enu;
}

std::optional<GnssTerms> GnssFactors::addTo(PoseGraph& graph, const IsInMap& is_in_map) const {
  GnssTerms terms;
  terms.looked_at = countOf(graph.poses().size());
  const std::vector<const Tied*> fixes = fixesOf(graph.poses().size(), is_in_map);
  if (georeference_) terms.yaw_deviation = georeference_->yaw_deviation;
  const std::optional<Pose> start = bestStart(graph, fixes, terms.yaw_deviation);
  if (!start) return std::nullopt;
  terms.enu = graph.addNode(*start);
  graph.addFactor(uprightStart(terms.enu, *start, config_.start_tilt));
  for (const Tied* tied : fixes)
    terms.fixes.push_back(graph.addFactor(factorOf(*tied, terms.enu), kernel()));
  return terms;
}

void GnssFactors::take(const PoseGraphSolution& solution, const GnssTerms& terms,
                       double min_inlier_weight) {
  used_ = terms.looked_at;
  T_map_enu_ = solution.poses[terms.enu.value];
  const LocalEnu reference(given_datum_ ? *given_datum_ : enu_->datum());
  Georeference now;
  now.datum = reference.datum();
  now.T_enu_map = reference.T_ecef_enu().inverse() * enu_->T_ecef_enu() * T_map_enu_->inverse();
  now.yaw_deviation = terms.yaw_deviation;
  now.fixes = terms.fixes.size();
  now.outliers = static_cast<std::size_t>(std::count_if(
      terms.fixes.begin(), terms.fixes.end(),
      [&](FactorId id) { return solution.factors[id.value].weight < min_inlier_weight; }));
  georeference_ = now;
}

}  // namespace revisit_slam
