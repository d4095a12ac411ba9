// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/world.h"

#include "buildings.h"
#include "car_shapes.h"
#include "furniture.h"
#include "ground.h"
#include "people.h"
#include "structures.h"
#include "traffic.h"
#include "vegetation.h"

namespace revisit_slam::simulation {
namespace {

void fillTown(Site& site, const Route& visit) {
  addBuildings(site, {});
  addEdging(site, {});
  addLampsAndSigns(site, 32.0);
  addStreetTrees(site, 14.0);
  addParkedCars(site, 0.35, visit);
  addEnclosures(site, 0.7);
  addScatteredTrees(site, 5.0, 2.6);
  addNewlyParkedCars(site, 0.2, visit);
}

void fillCampus(Site& site) {
  BuildingStyle style;
  style.narrowest = 14.0;
  style.widest = 26.0;
  style.deepest = 18.0;
  style.nearest = 2.5;
  style.farthest = 7.0;
  style.gap_share = 0.8;
  addBuildings(site, style);
  addBenches(site, 18.0);
  addLampsAndSigns(site, 25.0);
  addStreetTrees(site, 11.0);
  addEnclosures(site, 0.25);
  addScatteredTrees(site, 8.0, 0.8);
}

void fillField(Site& site) {
  addScatteredTrees(site, 0.12, 3.0);
  addFieldObjects(site, 0.25);
}

void fillRamp(Site& site) {
  addParkingDeck(site);
  BuildingStyle style;
  style.nearest = 6.0;
  style.farthest = 16.0;
  style.gap_share = 0.6;
  addBuildings(site, style);
  addScatteredTrees(site, 2.0, 3.0);
}

void fill(Site& site, const Route& visit) {
  switch (site.layout().kind) {
    case WorldKind::kBridge:
      if (site.layout().has_streets) addBridge(site);
      return fillTown(site, visit);
    case WorldKind::kTown:
      return fillTown(site, visit);
    case WorldKind::kCampus:
      return fillCampus(site);
    case WorldKind::kField:
      return fillField(site);
    case WorldKind::kRamp:
      return site.layout().has_streets ? fillRamp(site) : fillTown(site, visit);
    case WorldKind::kCorridor:
      return addCorridor(site);
    case WorldKind::kMotorway:
      return addMotorway(site);
    case WorldKind::kBays:
    case WorldKind::kTerraces:
    case WorldKind::kAisles:
    case WorldKind::kPortals:
      return addEqualRows(site);
    case WorldKind::kStoreys:
      return addStoreys(site);
  }
}

bool hasTraffic(WorldKind kind) {
  return kind == WorldKind::kTown || kind == WorldKind::kBridge || kind == WorldKind::kMotorway;
}

}  // namespace

World makeWorld(const WorldConfig& config, const Route& route) {
  return makeWorld(config, route, route);
}

World makeWorld(const WorldConfig& config, const Route& first, const Route& visit) {
  Site site(first);
  addGround(site);
  fill(site, visit);
  World world;
  for (int model = 0; model < carModelCount(); ++model) {
    addCar(world.models.emplace_back(), Placement{}, model);
  }
  if (hasTraffic(site.layout().kind)) world.cars = makeTraffic(visit, config.moving_cars);
  world.people = makePeople(site, visit, config.people, carModelCount());
  if (!world.people.empty())
    for (int model = 0; model < personModelCount(); ++model)
      addPerson(world.models.emplace_back(), model);
  world.still = std::move(site.mesh());
  return world;
}

}  // namespace revisit_slam::simulation
