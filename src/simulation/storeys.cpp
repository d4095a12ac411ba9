// SPDX-License-Identifier: MIT
#include "storeys.h"

#include "structures.h"

namespace revisit_slam::simulation {
namespace {

constexpr int kStoreys = 3;
constexpr double kHeight = 3.2, kSlab = 0.2;
constexpr double kLength = 40.0, kWidth = 24.0;  // of a floor, from the origin
/// The way goes around on each floor at this distance from the outer walls.
constexpr double kAside = 4.0;
/// A ramp lies before the building, from the door on in y; the way from its upper end back to the
/// door lies farther out.
constexpr double kRampX = -4.0, kBackX = -9.0, kRampLength = 30.0, kHalfWay = 2.0;

void append(Polyline& line, const Polyline& more) {
  line.insert(line.end(), more.begin(), more.end());
}

Polyline around(double z) {
  const double right = kLength - kAside, left = kWidth - kAside;
  return {{0.0, kAside, z},  {right, kAside, z},        {right, left, z},
          {kAside, left, z}, {kAside, 2.0 * kAside, z}, {0.0, kAside, z}};
}

/// From the door of a storey to that of the next.
Polyline up(double z) {
  const double far = kAside + kRampLength, next = z + kHeight;
  return {{kRampX, kAside, z},       {kRampX, kAside + 2.0, z}, {kRampX, far, next},
          {kRampX, far + 4.0, next}, {kBackX, far + 4.0, next}, {kBackX, kAside, next}};
}

/// A storey's walls with the door, the core, the columns, and what stands around; the floor lies at
/// z = 0.
void addStorey(TriangleMesh& mesh, const Placement& at) {
  const double top = kHeight - kSlab;
  addBox(mesh, at, {0.0, 0.0, -kSlab}, {kLength, kWidth, 0.0}, Material::kConcrete);
  addBox(mesh, at, {0.0, 0.0, 0.0}, {kLength, 0.2, top}, Material::kPlaster);
  addBox(mesh, at, {0.0, kWidth - 0.2, 0.0}, {kLength, kWidth, top}, Material::kPlaster);
  addBox(mesh, at, {kLength - 0.2, 0.0, 0.0}, {kLength, kWidth, top}, Material::kPlaster);
  addBox(mesh, at, {0.0, 0.0, 0.0}, {0.2, kAside - 2.0, top}, Material::kPlaster);
  addBox(mesh, at, {0.0, kAside + 2.0, 0.0}, {0.2, kWidth, top}, Material::kPlaster);
  addBox(mesh, at, {12.0, 9.0, 0.0}, {28.0, 15.0, top}, Material::kPlaster);
  for (double x = 7.0; x < kLength; x += 6.5)
    for (const double y : {6.5, kWidth - 6.5})
      addBox(mesh, at, {x - 0.2, y - 0.2, 0.0}, {x + 0.2, y + 0.2, top}, Material::kConcrete);
  addBox(mesh, at, {8.0, 0.3, 0.0}, {11.0, 1.2, 2.0}, Material::kPaint);
  addBox(mesh, at, {24.0, 0.3, 0.0}, {25.2, 1.4, 1.1}, Material::kPaint);
  addBox(mesh, at, {16.0, kWidth - 1.5, 0.0}, {18.4, kWidth - 0.4, 1.6}, Material::kPaint);
}

void addWay(TriangleMesh& mesh, double x, double from, double to, double z_from, double z_to) {
  const auto corner = [&](double side, bool begin, double rise) -> Eigen::Vector3d {
    return {x + side * kHalfWay, begin ? from : to, (begin ? z_from : z_to) + rise};
  };
  addQuad(mesh, corner(-1, true, 0), corner(1, true, 0), corner(1, false, 0), corner(-1, false, 0),
          Material::kConcrete);
  for (const double side : {-1.0, 1.0})
    addQuad(mesh, corner(side, true, 0), corner(side, false, 0), corner(side, false, 1.0),
            corner(side, true, 1.0), Material::kConcrete);
}

/// From the floor z to the next one.
void addRamp(TriangleMesh& mesh, double z) {
  const double far = kAside + kRampLength, next = z + kHeight;
  const Placement origin;
  addWay(mesh, kRampX, kAside + 2.0, far, z, next);
  addWay(mesh, kBackX, kAside + kHalfWay, far + 2.0, next, next);
  addBox(mesh, origin, {kBackX - kHalfWay, far, next - 0.1}, {kRampX + kHalfWay, far + 6.0, next},
         Material::kConcrete);
  addBox(mesh, origin, {kBackX - kHalfWay, kAside - 2.0, next - 0.1},
         {0.0, kAside + kHalfWay, next}, Material::kConcrete);
}

}  // namespace

Polyline throughStoreys(double length) {
  Polyline line = around(0.0);
  while (arcLengths(line).back() < 1.05 * length + 20.0) {
    for (int storey = 0; storey + 1 < kStoreys; ++storey) {
      append(line, up(storey * kHeight));
      append(line, around((storey + 1) * kHeight));
    }
    for (int storey = kStoreys - 2; storey >= 0; --storey) {
      const Polyline down = up(storey * kHeight);
      line.insert(line.end(), down.rbegin(), down.rend());
      append(line, around(storey * kHeight));
    }
  }
  return line;
}

void addStoreys(Site& site) {
  TriangleMesh& mesh = site.mesh();
  for (int storey = 0; storey < kStoreys; ++storey) {
    const double z = storey * kHeight;
    addStorey(mesh, {{0.0, 0.0, z}, 0.0});
    if (storey + 1 < kStoreys) addRamp(mesh, z);
  }
  const double roof = kStoreys * kHeight;
  addBox(mesh, {}, {0.0, 0.0, roof - kSlab}, {kLength, kWidth, roof}, Material::kConcrete);
}

}  // namespace revisit_slam::simulation
