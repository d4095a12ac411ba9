// SPDX-License-Identifier: MIT
#include "revisit_slam/types/informed_scan.h"

namespace revisit_slam {

const char* toString(InformationSource source) {
  switch (source) {
    case InformationSource::estimated:
      return "estimated";
    case InformationSource::repeated:
      return "repeated";
    case InformationSource::predicted:
      return "predicted";
    case InformationSource::identity:
      return "identity";
  }
  return "unknown";
}

}  // namespace revisit_slam
