// SPDX-License-Identifier: MIT
#include "car_shapes.h"

#include <array>

namespace revisit_slam::simulation {
namespace {

/// Heights and positions of the outline as parts of the size.
struct CarModel {
  CarSize size;
  double belt;
  double hood;
  double windscreen;
  double rear_window;
  double tail;
};

constexpr std::array<CarModel, 4> kModels{{
    {{4.3, 1.78, 1.48}, 0.62, 0.32, 0.10, -0.28, -0.46},
    {{4.7, 1.85, 1.70}, 0.60, 0.34, 0.16, -0.40, -0.49},
    {{5.2, 1.95, 2.10}, 0.52, 0.42, 0.28, -0.48, -0.50},
    {{3.7, 1.65, 1.50}, 0.60, 0.34, 0.14, -0.36, -0.48},
}};

constexpr double kClearance = 0.22;

void addWheels(TriangleMesh& mesh, const Placement& at, const CarSize& size) {
  for (const double x : {-0.3, 0.31}) {
    for (const double y : {-0.5, 0.5}) {
      const double side = y * size.width;
      const double inner = 0.86 * side;
      addCylinder(mesh, at.at(x * size.length, inner, 0.31), at.at(x * size.length, side, 0.31),
                  0.31, 0.31, 12, Material::kAsphalt);
    }
  }
}

void addCabin(TriangleMesh& mesh, const Placement& at, const CarModel& model) {
  const double l = model.size.length, half = 0.5 * model.size.width, roof_half = 0.8 * half;
  const double belt = model.belt * model.size.height, top = model.size.height;
  const auto low = [&](double x, double side) { return at.at(x * l, side * 0.97 * half, belt); };
  const auto high = [&](double x, double side) { return at.at(x * l, side * roof_half, top); };
  const double rear = 0.5 * (model.rear_window + model.tail);
  addQuad(mesh, low(model.hood, -1), low(model.hood, 1), high(model.windscreen, 1),
          high(model.windscreen, -1), Material::kGlass);
  addQuad(mesh, low(rear, -1), low(rear, 1), high(model.rear_window, 1),
          high(model.rear_window, -1), Material::kGlass);
  addQuad(mesh, high(model.windscreen, -1), high(model.windscreen, 1), high(model.rear_window, 1),
          high(model.rear_window, -1), Material::kPaint);
  for (const double side : {-1.0, 1.0}) {
    addQuad(mesh, low(model.hood, side), low(rear, side), high(model.rear_window, side),
            high(model.windscreen, side), Material::kGlass);
  }
}

}  // namespace

int carModelCount() {
  return static_cast<int>(kModels.size());
}

CarSize carSize(int model) {
  return kModels[static_cast<std::size_t>(model)].size;
}

void addCar(TriangleMesh& mesh, const Placement& at, int model) {
  const CarModel& car = kModels[static_cast<std::size_t>(model)];
  const double l = 0.5 * car.size.length, w = 0.5 * car.size.width;
  const double belt = car.belt * car.size.height, hood = car.hood * car.size.length;
  addBox(mesh, at, {-l, -w, kClearance}, {hood, w, belt}, Material::kPaint);
  addBox(mesh, at, {hood, -0.97 * w, kClearance}, {l, 0.97 * w, 0.88 * belt}, Material::kPaint);
  addCabin(mesh, at, car);
  addWheels(mesh, at, car.size);
}

}  // namespace revisit_slam::simulation
