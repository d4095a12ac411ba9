// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/information_stage.h"

namespace revisit_slam {

const char* toString(InformationSource source) {
  switch (source) {
    case InformationSource::estimated: return "estimated";
    case InformationSource::repeated: return "repeated";
    case InformationSource::identity: return "identity";
  }
  return "unknown";
}

InformationStage::InformationStage(const InformationConfig& config)
    : estimator_(config), covariance_(config) {}

InformedScan InformationStage::inform(std::shared_ptr<const RegisteredScan> scan) {
  InformedScan informed;
  informed.scan = std::move(scan);
  covariance_.observe(informed.scan->deskew_error);
  if (informed.scan->problem.points_base.empty()) return informed;
  arena_.execute([&] { informed.estimate = estimator_.estimate(informed.scan->problem); });
  informed.source = InformationSource::estimated;
  informed.covariance_motion = covariance_.of(informed.estimate);
  last_estimate_ = informed.estimate;
  return informed;
}

InformedScan InformationStage::repeat(std::shared_ptr<const RegisteredScan> scan) {
  covariance_.observe(scan->deskew_error);
  return {std::move(scan), last_estimate_, InformationSource::repeated,
          covariance_.of(last_estimate_)};
}

void InformationStage::reconfigure(const InformationConfig& config) {
  covariance_.reconfigure(config);
  estimator_.setWeakRatio(config.weak_ratio);
}

}  // namespace revisit_slam
