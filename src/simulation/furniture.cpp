// SPDX-License-Identifier: MIT
#include "furniture.h"

#include "car_shapes.h"
#include "roadside.h"
#include "vegetation.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kClearOfRoute = 2.5;

void addLamp(TriangleMesh& mesh, const Placement& at, Random& random) {
  const double height = random.uniform(4.5, 8.5);
  addCylinder(mesh, at.at(0, 0, -0.2), at.at(0, 0, height), 0.1, 0.06, 8, Material::kMetal);
  addCylinder(mesh, at.at(0, 0, height), at.at(0, -1.4, height + 0.25), 0.04, 0.03, 5,
              Material::kMetal);
  addBox(mesh, at, {-0.15, -1.9, height + 0.15}, {0.15, -1.2, height + 0.3}, Material::kMetal);
}

void addSign(TriangleMesh& mesh, const Placement& at, Random& random) {
  const double height = random.uniform(1.9, 2.6), half = random.uniform(0.25, 0.45);
  addCylinder(mesh, at.at(0, 0, -0.2), at.at(0, 0, height + half), 0.035, 0.035, 6,
              Material::kMetal);
  addBox(mesh, at, {-0.02, -half, height - half}, {0.0, half, height + half}, Material::kSignFace);
}

void addBench(TriangleMesh& mesh, const Placement& at) {
  addBox(mesh, at, {-0.9, -0.25, 0.4}, {0.9, 0.25, 0.46}, Material::kBark);
  addBox(mesh, at, {-0.9, 0.22, 0.46}, {0.9, 0.27, 0.9}, Material::kBark);
  for (const double x : {-0.75, 0.75}) {
    addBox(mesh, at, {x - 0.04, -0.2, -0.1}, {x + 0.04, 0.2, 0.4}, Material::kMetal);
  }
}

void addSteps(TriangleMesh& mesh, const Placement& at, Random& random) {
  const int steps = random.integer(3, 9);
  for (int k = 0; k < steps; ++k) {
    addBox(mesh, at, {-1.5, 0.32 * k, -0.3}, {1.5, 0.32 * (steps + 4), 0.16 * (k + 1)},
           Material::kConcrete);
  }
}

void addFence(TriangleMesh& mesh, const Placement& at, double length, double height) {
  for (double x = -0.5 * length; x <= 0.5 * length; x += 0.9) {
    addBox(mesh, at, {x - 0.05, -0.04, -0.3}, {x + 0.05, 0.04, height}, Material::kBark);
  }
  for (const double z : {0.3 * height, 0.85 * height}) {
    addBox(mesh, at, {-0.5 * length, -0.03, z - 0.05}, {0.5 * length, 0.03, z + 0.05},
           Material::kBark);
  }
}

void addEnclosure(Site& site, const Placement& at, double length, Random& random) {
  TriangleMesh& mesh = site.mesh();
  const double height = random.uniform(0.7, 1.8);
  const int kind = random.integer(0, 2);
  if (kind == 0) {
    addFence(mesh, at, length, height);
  } else if (kind == 1) {
    addBox(mesh, at, {-0.5 * length, -0.12, -0.4}, {0.5 * length, 0.12, 0.8 * height},
           Material::kBrick);
  } else {
    for (double x = -0.5 * length; x <= 0.5 * length; x += 0.6) {
      addBush(mesh, at.at(x, random.uniform(-0.1, 0.1), 0.0), 0.6 * height, random);
    }
  }
}

/// Whether the platform of a drive gets by.
bool leavesFree(const Route& drive, const Plot& plot) {
  const double reach = kClearOfRoute + plot.half_length;
  const Eigen::Vector2d centre = plot.centre.origin.head<2>();
  for (const Eigen::Vector3d& p : drive.path()) {
    if ((p.head<2>() - centre).squaredNorm() > reach * reach) continue;
    if (overlap(plot, {{p, plot.centre.yaw}, kClearOfRoute - 1.0, kClearOfRoute - 1.0}))
      return false;
  }
  return true;
}

}  // namespace

void addLampsAndSigns(Site& site, double spacing) {
  Random random(hashOf(site.layout().seed, 950));
  alongRoadsides(site, random, spacing, 0.5, [&](const Placement& at) {
    const bool sign = random.chance(0.45);
    if (!site.isFree({at, 0.2, 0.2}, 0.2)) return;
    site.occupy({at, 0.2, 0.2});
    if (sign) {
      addSign(site.mesh(), at, random);
    } else {
      addLamp(site.mesh(), at, random);
    }
  });
}

void addEnclosures(Site& site, double share) {
  Random random(hashOf(site.layout().seed, 951));
  alongRoadsides(site, random, 8.0, 2.3, [&](const Placement& at) {
    const double length = random.uniform(4.0, 9.0);
    if (!random.chance(share) || !site.isFree({at, 0.5 * length, 0.25}, 1.6)) return;
    site.occupy({at, 0.5 * length, 0.25});
    addEnclosure(site, at, length, random);
  });
}

void addParkedCars(Site& site, double share, const Route& visit) {
  const auto number = static_cast<std::uint64_t>(visit.visit().number);
  Random random(hashOf(site.layout().seed, 952)), change(hashOf(site.layout().seed, 955, number));
  alongRoadsides(site, random, 6.4, -1.0, [&](const Placement& at) {
    const int model = random.integer(0, carModelCount() - 1);
    const Placement place =
        at.moved(0.0, random.uniform(-0.1, 0.15), 0.0,
                 random.uniform(-0.04, 0.04) + (random.chance(0.5) ? 3.14159 : 0.0));
    const CarSize size = carSize(model);
    const Plot plot{place, 0.5 * size.length + 0.3, 0.5 * size.width};
    if (!random.chance(share) || !site.isFree(plot, -2.3)) return;
    for (const double x : {-0.5, 0.0, 0.5}) {
      const Eigen::Vector2d inner = at.flat(x * size.length, -0.5 * size.width);
      if (site.fromRoute(inner) < kClearOfRoute - 1.0) return;
    }
    site.occupy(plot);
    if (number == 0) return addCar(site.mesh(), place, model);
    const bool stays = change.chance(0.5);
    const int other = change.integer(0, carModelCount() - 1);
    const Placement moved = place.moved(change.uniform(-0.4, 0.4), 0.0, 0.0);
    if (stays && leavesFree(visit, {moved, 0.5 * carSize(other).length, 0.5 * size.width}))
      addCar(site.mesh(), moved, other);
  });
}

void addNewlyParkedCars(Site& site, double share, const Route& visit) {
  const auto number = static_cast<std::uint64_t>(visit.visit().number);
  if (number == 0) return;
  Random random(hashOf(site.layout().seed, 956, number));
  alongRoadsides(site, random, 6.4, -1.0, [&](const Placement& at) {
    const int model = random.integer(0, carModelCount() - 1);
    const CarSize size = carSize(model);
    const Plot plot{at, 0.5 * size.length + 0.3, 0.5 * size.width};
    if (!random.chance(share) || !site.isFree(plot, -2.3) || !leavesFree(visit, plot)) return;
    site.occupy(plot);
    addCar(site.mesh(), at, model);
  });
}

void addBenches(Site& site, double spacing) {
  Random random(hashOf(site.layout().seed, 953));
  alongRoadsides(site, random, spacing, 1.0, [&](const Placement& at) {
    const bool steps = random.chance(0.25);
    const Plot plot{at.moved(0.0, steps ? 2.0 : 0.0, 0.0), steps ? 1.6 : 1.0, steps ? 2.2 : 0.4};
    if (!site.isFree(plot, 0.2)) return;
    site.occupy(plot);
    if (steps) {
      addSteps(site.mesh(), at, random);
    } else {
      addBench(site.mesh(), at);
    }
  });
}

void addFieldObjects(Site& site, double density) {
  Random random(hashOf(site.layout().seed, 954));
  const Neighbourhood& near = site.neighbourhood();
  const Eigen::Vector2d size = near.high() - near.low();
  for (int k = 0; k < static_cast<int>(size.prod() * density / 1000.0); ++k) {
    const Eigen::Vector2d p =
        near.low() + Eigen::Vector2d(random.uniform(0.0, size.x()), random.uniform(0.0, size.y()));
    const Placement at{{p.x(), p.y(), site.ground(p)}, random.uniform(0.0, 6.28)};
    if (!site.isFree({at, 1.2, 1.2}, 1.0)) continue;
    site.occupy({at, 1.2, 1.2});
    const int kind = random.integer(0, 2);
    const double r = random.uniform(0.3, 0.8);
    if (kind == 0)
      addBox(site.mesh(), at, {-r, -0.6 * r, -0.3}, {r, 0.6 * r, r}, Material::kConcrete);
    if (kind == 1)
      addCylinder(site.mesh(), at.at(-0.6, 0, 0.6), at.at(0.6, 0, 0.6), 0.65, 0.65, 14,
                  Material::kGrass);
    if (kind == 2) addFence(site.mesh(), at, 12.0 * r, 1.2);
  }
}

}  // namespace revisit_slam::simulation
