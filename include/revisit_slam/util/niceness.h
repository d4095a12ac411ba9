// SPDX-License-Identifier: MIT
#pragma once

namespace revisit_slam {

/// Lets the calling thread stand back behind others of the machine, 0 (not) … 19 (most). Where the
/// system does not allow it everything stays as it is.
void setThreadNiceness(int niceness);

}  // namespace revisit_slam
