// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/ray_caster.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace revisit_slam::simulation {

struct RayCaster::Scene {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Material> materials;

  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

namespace {

RTCGeometry makeGeometry(RTCDevice device, const TriangleMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           3 * sizeof(float), mesh.vertices.size());
  void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(std::uint32_t), mesh.triangles.size());
  if (vertices == nullptr || triangles == nullptr) {
    throw std::runtime_error("no memory for a world of " + std::to_string(mesh.triangles.size()) +
                             " triangles");
  }
  std::copy_n(mesh.vertices.front().data(), 3 * mesh.vertices.size(),
              static_cast<float*>(vertices));
  std::copy_n(mesh.triangles.front().data(), 3 * mesh.triangles.size(),
              static_cast<std::uint32_t*>(triangles));
  rtcCommitGeometry(geometry);
  return geometry;
}

/// So that the tree, and with it every tie between triangles, is always the same. (The device's own
/// option for this would limit all threads of the program for as long as the device lives.)
void commitWithOneThread(RTCScene scene) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  rtcCommitScene(scene);
}

void intersect(RTCScene scene, RTCRayHit& query) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
#endif
}

}  // namespace

RayCaster::RayCaster(const TriangleMesh& mesh) : scene_(std::make_unique<Scene>()) {
  if (mesh.triangles.empty()) throw std::invalid_argument("a world without triangles");
  scene_->device = rtcNewDevice(nullptr);
  if (scene_->device == nullptr) throw std::runtime_error("the ray tracer does not start");
  scene_->scene = rtcNewScene(scene_->device);
  rtcSetSceneFlags(scene_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = makeGeometry(scene_->device, mesh);
  rtcAttachGeometry(scene_->scene, geometry);
  rtcReleaseGeometry(geometry);
  commitWithOneThread(scene_->scene);
  scene_->materials = mesh.materials;
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&& other) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&& other) noexcept = default;

std::optional<RayHit> RayCaster::cast(const Eigen::Vector3d& origin,
                                      const Eigen::Vector3d& direction, double max_range) const {
  const Eigen::Vector3f o = origin.cast<float>(), d = direction.cast<float>();
  RTCRayHit query{};
  query.ray = {o.x(), o.y(), o.z(), 0.0F, d.x(), d.y(), d.z(), 0.0F, static_cast<float>(max_range),
               ~0U,   0,     0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  intersect(scene_->scene, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Eigen::Vector3f normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
  const float length = normal.norm();
  const float cosine = length > 0.0F ? std::abs(normal.dot(d)) / length : 0.0F;
  return RayHit{static_cast<double>(query.ray.tfar), static_cast<double>(cosine),
                scene_->materials[query.hit.primID]};
}

}  // namespace revisit_slam::simulation
