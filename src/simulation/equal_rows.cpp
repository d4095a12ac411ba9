// SPDX-License-Identifier: MIT
#include "equal_rows.h"

#include "car_shapes.h"
#include "revisit_slam/simulation/random.h"
#include "structures.h"

namespace revisit_slam::simulation {
namespace {

/// Of a lane's end, where the platform turns.
constexpr double kFreeEnds = 5.0;

EqualRows usualRows(WorldKind kind) {
  switch (kind) {
    case WorldKind::kBays:
      return {4, 16.0, 160.0, 2.6, 14.0};
    case WorldKind::kTerraces:
      return {4, 120.0, 260.0, 14.0, 20.0};
    case WorldKind::kAisles:
      return {6, 5.0, 50.0, 2.8, 5.0};
    default:
      return {2, 11.0, 400.0, 25.0, 6.0};
  }
}

/// A car in a bay, its front towards the lane.
void addBay(TriangleMesh& mesh, const Placement& beside) {
  addCar(mesh, beside.moved(0.0, 4.6, 0.0, -1.5708), 0);
}

void addHouse(TriangleMesh& mesh, const Placement& beside) {
  addBox(mesh, beside, {-5.0, 9.0, 0.0}, {5.0, 18.0, 6.5}, Material::kPlaster);
  addBox(mesh, beside, {-0.6, 8.6, 0.0}, {0.6, 9.0, 2.2}, Material::kPaint);
  for (const double x : {-3.4, 3.4})
    addBox(mesh, beside, {x - 0.7, 8.85, 1.0}, {x + 0.7, 9.0, 2.2}, Material::kGlass);
  addBox(mesh, beside, {-7.0, 6.0, 0.0}, {5.6, 6.2, 0.9}, Material::kBrick);
}

/// One field of a rack, with its boards and boxes.
void addRack(TriangleMesh& mesh, const Placement& beside, double spacing) {
  const double half = 0.5 * spacing;
  addBox(mesh, beside, {-half, 1.4, 0.0}, {-half + 0.1, 2.4, 7.0}, Material::kMetal);
  for (const double z : {0.15, 2.0, 4.0, 6.0})
    addBox(mesh, beside, {-half, 1.4, z}, {half, 2.4, z + 0.1}, Material::kMetal);
  for (const double z : {0.25, 2.1, 4.1})
    addBox(mesh, beside, {-0.5, 1.5, z}, {0.6, 2.4, z + 1.1}, Material::kPaint);
}

/// Half of a portal: a column and the beam up to the middle of the lane.
void addPortal(TriangleMesh& mesh, const Placement& beside) {
  addBox(mesh, beside, {-0.25, 4.0, 0.0}, {0.25, 4.5, 6.0}, Material::kMetal);
  addBox(mesh, beside, {-0.25, 0.0, 5.5}, {0.25, 4.0, 6.0}, Material::kMetal);
}

/// What stands left of a place on a lane, whose x axis points along it.
void addBeside(TriangleMesh& mesh, WorldKind kind, const Placement& beside, double spacing) {
  switch (kind) {
    case WorldKind::kBays:
      return addBay(mesh, beside);
    case WorldKind::kTerraces:
      return addHouse(mesh, beside);
    case WorldKind::kAisles:
      return addRack(mesh, beside, spacing);
    default:
      return addPortal(mesh, beside);
  }
}

/// Walls around all lanes, and a ceiling where it has a height.
void addHall(TriangleMesh& mesh, const EqualRows& rows, double margin, double height) {
  const double low = -rows.run_out - margin, high = rows.length + margin + kFreeEnds;
  const double right = -margin, left = (rows.lanes - 1) * rows.pitch + margin;
  const Placement origin;
  addBox(mesh, origin, {low - 0.3, right, 0.0}, {low, left, height}, Material::kConcrete);
  addBox(mesh, origin, {high, right, 0.0}, {high + 0.3, left, height}, Material::kConcrete);
  addBox(mesh, origin, {low, right - 0.3, 0.0}, {high, right, height}, Material::kConcrete);
  addBox(mesh, origin, {low, left, 0.0}, {high, left + 0.3, height}, Material::kConcrete);
  addBox(mesh, origin, {low, right, height}, {high, left, height + 0.3}, Material::kConcrete);
}

void addRailings(TriangleMesh& mesh, const EqualRows& rows) {
  const double low = -rows.run_out - 14.0, high = rows.length + rows.run_out + 14.0;
  for (const double y : {-5.5, (rows.lanes - 1) * rows.pitch + 5.5})
    addBox(mesh, {}, {low, y - 0.1, 0.0}, {high, y + 0.1, 1.1}, Material::kConcrete);
}

}  // namespace

bool hasEqualRows(WorldKind kind) {
  return kind == WorldKind::kBays || kind == WorldKind::kTerraces || kind == WorldKind::kAisles ||
         kind == WorldKind::kPortals;
}

EqualRows equalRows(WorldKind kind, std::uint64_t seed) {
  EqualRows rows = usualRows(kind);
  Random random(hashOf(seed, 985));
  rows.pitch *= random.uniform(0.97, 1.03);
  rows.spacing *= random.uniform(0.95, 1.05);
  return rows;
}

Polyline alongRows(const EqualRows& rows, double length) {
  Polyline line;
  const double last = (rows.lanes - 1) * rows.pitch;
  while (line.empty() || arcLengths(line).back() < 1.05 * length + 20.0) {
    for (int lane = 0; lane < rows.lanes; ++lane) {
      const double begin = lane % 2 == 0 ? 0.0 : rows.length;
      line.emplace_back(begin, lane * rows.pitch, 0.0);
      line.emplace_back(rows.length - begin, lane * rows.pitch, 0.0);
    }
    line.emplace_back(-rows.run_out, last, 0.0);
    line.emplace_back(-rows.run_out, 0.0, 0.0);
  }
  return line;
}

void addEqualRows(Site& site) {
  const WorldKind kind = site.layout().kind;
  const EqualRows rows = equalRows(kind, site.layout().seed);
  for (int lane = 0; lane < rows.lanes; ++lane) {
    for (double x = kFreeEnds + 0.5 * rows.spacing; x < rows.length - kFreeEnds;
         x += rows.spacing) {
      const Placement ahead{{x, lane * rows.pitch, 0.0}, 0.0};
      addBeside(site.mesh(), kind, ahead, rows.spacing);
      addBeside(site.mesh(), kind, ahead.moved(0.0, 0.0, 0.0, M_PI), rows.spacing);
    }
  }
  if (kind == WorldKind::kAisles) addHall(site.mesh(), rows, 4.0, 9.0);
  if (kind == WorldKind::kPortals) addRailings(site.mesh(), rows);
}

}  // namespace revisit_slam::simulation
