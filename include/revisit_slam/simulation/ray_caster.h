// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "revisit_slam/simulation/mesh.h"

namespace revisit_slam::simulation {

struct RayHit {
  /// Metres from the origin of the ray.
  double range = 0.0;
  /// Cosine of the angle between the ray and the surface's normal, 0 to 1.
  double cosine = 1.0;
  Material material = Material::kAsphalt;
};

/// Finds the first triangle that a ray meets. Casting is safe from several threads.
class RayCaster {
 public:
  explicit RayCaster(const TriangleMesh& mesh);
  ~RayCaster();
  RayCaster(RayCaster&& other) noexcept;
  RayCaster& operator=(RayCaster&& other) noexcept;

  /// @param direction of unit length.
  std::optional<RayHit> cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                             double max_range) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace revisit_slam::simulation
