// SPDX-License-Identifier: MIT
#include "revisit_slam/input/kept_points.h"

#include <array>
#include <cmath>

#include "revisit_slam/input/load_number.h"

namespace revisit_slam {
namespace {

bool isFinite(const Eigen::Vector3f& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

/// Writes every point and steps on only past those to keep: no branch that dropouts mispredict.
template <typename LoadPoint>
KeptPoints keepMeasurements(const PointView& view, LoadPoint loadPoint) {
  KeptPoints kept;
  const std::size_t received = view.width * view.height;
  kept.points.resize(received);
  kept.byte_offsets.resize(received);
  std::size_t count = 0;
  std::size_t finite = 0;
  for (std::size_t row = 0; row < view.height; ++row) {
    std::size_t offset = row * view.row_step;
    for (std::size_t column = 0; column < view.width; ++column, offset += view.point_step) {
      const Eigen::Vector3f point = loadPoint(view.data + offset);
      const bool is_finite = isFinite(point);
      const bool at_origin = point.x() == 0.f && point.y() == 0.f && point.z() == 0.f;
      kept.points[count] = point;
      kept.byte_offsets[count] = static_cast<std::uint32_t>(offset);
      finite += is_finite;
      count += is_finite && !at_origin;
    }
  }
  kept.points.resize(count);
  kept.byte_offsets.resize(count);
  kept.counts = {received, received - finite, finite - count, 0, count};
  return kept;
}

using LoadFloat = float (*)(const std::uint8_t*);

template <bool swapped>
LoadFloat floatLoader(NumberType type) {
  LoadFloat load = nullptr;
  withNumberType(type, [&load](auto zero) {
    load = [](const std::uint8_t* p) {
      return static_cast<float>(loadNumber<decltype(zero), swapped>(p));
    };
  });
  return load;
}

/// A function call per coordinate: for the messages that are not plain floats.
KeptPoints readAnyPoints(const PointView& view, const std::array<const PointField*, 3>& xyz) {
  std::array<LoadFloat, 3> load{};
  for (std::size_t i = 0; i < 3; ++i) {
    load[i] = view.swapped ? floatLoader<true>(xyz[i]->type) : floatLoader<false>(xyz[i]->type);
  }
  return keepMeasurements(view, [&](const std::uint8_t* p) {
    return Eigen::Vector3f(load[0](p + xyz[0]->offset), load[1](p + xyz[1]->offset),
                           load[2](p + xyz[2]->offset));
  });
}

KeptPoints readFloatPoints(const PointView& view, std::size_t x, std::size_t y, std::size_t z) {
  return keepMeasurements(view, [x, y, z](const std::uint8_t* p) {
    return Eigen::Vector3f(loadNumber<float, false>(p + x), loadNumber<float, false>(p + y),
                           loadNumber<float, false>(p + z));
  });
}

template <typename T, bool swapped, typename Value>
void loadAll(const std::uint8_t* data, const std::vector<std::uint32_t>& offsets, Value* out) {
  for (const std::uint32_t offset : offsets) {
    *out++ = static_cast<Value>(loadNumber<T, swapped>(data + offset));
  }
}

template <typename Value>
std::vector<Value> readValues(const PointView& view, const PointField& field,
                              const std::vector<std::uint32_t>& byte_offsets) {
  std::vector<Value> values(byte_offsets.size());
  const std::uint8_t* first = view.data + field.offset;
  withNumberType(field.type, [&](auto zero) {
    using T = decltype(zero);
    view.swapped ? loadAll<T, true>(first, byte_offsets, values.data())
                 : loadAll<T, false>(first, byte_offsets, values.data());
  });
  return values;
}

}  // namespace

KeptPoints readPoints(const PointView& view) {
  const std::array<const PointField*, 3> xyz{view.find("x"), view.find("y"), view.find("z")};
  bool plain = !view.swapped;
  for (const PointField* field : xyz) plain = plain && field->type == NumberType::float32;
  return plain ? readFloatPoints(view, xyz[0]->offset, xyz[1]->offset, xyz[2]->offset)
               : readAnyPoints(view, xyz);
}

std::vector<double> readField(const PointView& view, const PointField& field,
                              const std::vector<std::uint32_t>& byte_offsets) {
  return readValues<double>(view, field, byte_offsets);
}

std::vector<float> readIntensities(const PointView& view,
                                   const std::vector<std::uint32_t>& byte_offsets) {
  for (const char* name : {"intensity", "reflectivity"}) {
    const PointField* field = view.find(name);
    if (field == nullptr || field->type == NumberType::unknown) continue;
    std::vector<float> intensities = readValues<float>(view, *field, byte_offsets);
    for (float& intensity : intensities)
      if (!std::isfinite(intensity)) intensity = 0.0f;
    return intensities;
  }
  return {};
}

}  // namespace revisit_slam
