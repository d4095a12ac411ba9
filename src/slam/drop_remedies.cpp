// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/drop_remedies.h"

#include <algorithm>
#include <array>
#include <utility>

namespace revisit_slam {
namespace {

/// Reasons by how they begin.
constexpr std::array<std::pair<const char*, const char*>, 17> kRemedies{{
    {"no stamp",
     "the header stamps are zero: let the driver set them, or set input/stamps to arrival"},
    {"no field of the given name",
     "set input/time_field to auto, or to a field that the messages have"},
    {"no transform",
     "broadcast the transform, or estimate the pose of the sensor itself: base_frame:=none live, "
     "--base-frame none offline"},
    {"wrong transform",
     "broadcast the transform from base frame to sensor, as it is mounted, and set frames/base to "
     "a "
     "frame of the robot"},
    {"duplicate stamp",
     "do two nodes publish on the topic of the scans? If not, the driver stamps wrongly: set "
     "input/stamps to arrival"},
    {"time went back",
     "do two nodes publish on the topic of the scans, or is the clock of the sensor set while it "
     "runs? If the stamps stay wrong, set input/stamps to arrival"},
    {"stamp ahead", "if this goes on, the driver stamps wrongly: set input/stamps to arrival"},
    {"stamp out of range", "set input/time_unit and input/time_origin, or input/stamps to arrival"},
    {"queue full",
     "the odometry did not take them in time: leave it more of the processor (odometry/threads, "
     "other programs), or raise live/queue_size for short bursts"},
    {"no points", "the driver sends empty clouds: is the sensor spinning and in range?"},
    {"no finite points", "all points are NaN or at the origin: does the sensor see anything?"},
    {"no x, y, z", "the messages are no clouds of points: choose another topic"},
    {"no point in range", "all points are outside of odometry/min_range to odometry/max_range"},
    {"too small a part",
     "messages that hold parts of a sweep are lost on their way: run the driver and revisit_slam "
     "in one nodelet manager"},
    {"bad layout", "the messages contradict themselves: update or repair the driver"},
    {"unsupported message type", "choose a topic of sensor_msgs/PointCloud2 or Livox CustomMsg"},
    {"unreadable", "the recording is damaged: try rosbag reindex, or record anew"},
}};

}  // namespace

std::string remedyForDrop(const std::string& reason) {
  for (const auto& [start, remedy] : kRemedies)
    if (reason.rfind(start, 0) == 0) return remedy;
  return "";
}

std::string describeDrops(const ScanAccount& account) {
  if (account.droppedInAll() == 0) return "";
  const auto most =
      std::max_element(account.dropped.begin(), account.dropped.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  const std::string remedy = remedyForDrop(most->first);
  return std::to_string(account.droppedInAll()) + " of " + std::to_string(account.received) +
         " scans dropped, " + std::to_string(most->second) + " of them for '" + most->first + "'" +
         (remedy.empty() ? "" : ": " + remedy);
}

}  // namespace revisit_slam
