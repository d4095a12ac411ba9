// SPDX-License-Identifier: MIT
#include "revisit_slam/input/scan_reading.h"

namespace revisit_slam {

const char* describe(ScanRejection rejection) {
  switch (rejection) {
    case ScanRejection::none:
      return "none";
    case ScanRejection::empty:
      return "no points";
    case ScanRejection::no_finite_points:
      return "no finite points";
    case ScanRejection::missing_xyz:
      return "no x, y, z";
    case ScanRejection::bad_layout:
      return "bad layout";
    case ScanRejection::bad_stamp:
      return "stamp out of range";
    case ScanRejection::no_stamp:
      return "no stamp";
    case ScanRejection::no_time_field:
      return "no field of the given name";
    case ScanRejection::unsupported_type:
      return "unsupported message type";
    case ScanRejection::internal_error:
      return "internal error";
  }
  return "";
}

}  // namespace revisit_slam
