// SPDX-License-Identifier: MIT
#include "revisit_slam/input/point_view.h"

#include <limits>

namespace revisit_slam {
namespace {

std::string shapeOf(const PointView& view) {
  return std::to_string(view.width) + " x " + std::to_string(view.height) + " points, point_step " +
         std::to_string(view.point_step) + ", row_step " + std::to_string(view.row_step) + ", " +
         std::to_string(view.size) + " bytes";
}

std::string fieldFault(const PointView& view) {
  for (const PointField& field : view.fields) {
    const std::size_t size = sizeOf(field.type);
    if (field.offset > view.point_step || size > view.point_step - field.offset) {
      return "field '" + field.name + "' ends at byte " + std::to_string(field.offset + size) +
             ", point_step is " + std::to_string(view.point_step);
    }
  }
  return {};
}

/// Divides instead of multiplying, as announced numbers may overflow any product.
bool rowsFit(const PointView& view) {
  if (view.width > view.size / view.point_step) return false;
  const std::size_t one_row = view.width * view.point_step;
  return view.height == 1 || view.height - 1 <= (view.size - one_row) / view.row_step;
}

}  // namespace

const PointField* PointView::find(const std::string& name) const {
  for (const PointField& field : fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

std::string PointView::fieldNames() const {
  std::string names;
  for (const PointField& field : fields) names += (names.empty() ? "" : " ") + field.name;
  return names.empty() ? "none" : names;
}

std::string layoutFault(const PointView& view) {
  if (view.point_step == 0) return "point_step is 0";
  if (const std::string fault = fieldFault(view); !fault.empty()) return fault;
  if (view.size > std::numeric_limits<std::uint32_t>::max()) {
    return "more than 4 GiB: " + shapeOf(view);
  }
  // Drivers leave row_step unset where there is one row, which does not need it.
  if (view.height > 1 && view.row_step / view.point_step < view.width) {
    return "row_step too small: " + shapeOf(view);
  }
  return rowsFit(view) ? std::string{} : "data shorter than announced: " + shapeOf(view);
}

}  // namespace revisit_slam
