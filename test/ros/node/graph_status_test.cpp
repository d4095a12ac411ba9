// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/graph_status.h"

#include <gtest/gtest.h>

#include "support/contains.h"

namespace revisit_slam {
namespace {

diagnostic_msgs::DiagnosticStatus statusOf(GraphSession& session) {
  GraphStatus status;
  diagnostic_msgs::DiagnosticStatus message;
  status.note(session);
  status.tell(0, message);
  return message;
}

/// The graph goes on without its folder, and says so as long as that lasts.
TEST(GraphStatus, AFolderThatCannotBeWrittenIsAnErrorWithItsReason) {
  const auto ignore = [](const MapCorrectionPtr&) {};
  GraphSession session({}, {}, {}, {"/proc/nowhere/session", "", nullptr, false}, ignore);
  for (std::uint32_t i = 0; i < 40; ++i)
    session.add(GraphNode{{i}, Stamp::fromSeconds(0.1 * i), {}, Matrix6::Identity()});
  EXPECT_EQ(session.graph().size(), 40u);
  EXPECT_THROW(session.saveOwn(), std::runtime_error);
  for (int times = 0; times < 2; ++times) {
    const auto message = statusOf(session);
    EXPECT_EQ(message.level, message.ERROR);
    EXPECT_TRUE(contains(message.message, "/proc/nowhere")) << message.message;
    EXPECT_TRUE(contains(message.message, "No such file or directory")) << message.message;
  }
}

TEST(GraphStatus, WithoutAFolderNothingIsMissing) {
  GraphSession session({}, {}, {}, {}, [](const MapCorrectionPtr&) {});
  const auto message = statusOf(session);
  EXPECT_EQ(message.level, message.OK);
}

}  // namespace
}  // namespace revisit_slam
