// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where port/companion is told to fly to, and over which links: what it reads and what it refuses.
#include "companion/goals.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "companion/mission_file.hpp"
#include "companion/transport.hpp"

namespace tern_companion {
namespace {

constexpr double kClose = 1e-6;

template <class Message>
GoalMessage goal_of(const Message& message, const LocalFrame* local) {
  Sender ground{255, 190, 0};
  const std::vector<std::uint8_t> bytes = pack(ground, message);
  FrameReader reader;
  reader.feed(bytes.data(), bytes.size());
  Frame frame;
  EXPECT_TRUE(reader.next(frame));
  const auto goal = read_goal(frame, Sender{1, kCompanionComponent, 0}, local);
  EXPECT_TRUE(goal.has_value());
  return goal.value_or(GoalMessage{});
}

TEST(CompanionGoals, ComeFromGroundStationsInTheirFrames) {
  using Kind = GoalMessage::Kind;
  SetPositionTarget target;
  target.position = {1, 2, -3};
  target.target_system = 1;
  target.target_component = kCompanionComponent;
  GoalMessage goal = goal_of(target, nullptr);
  EXPECT_EQ(goal.kind, Kind::kGoal);
  EXPECT_EQ(goal.goal.x, 2.0);
  EXPECT_EQ(goal.goal.z, 3.0);
  target.coordinate_frame = 8;
  EXPECT_EQ(goal_of(target, nullptr).kind, Kind::kRefused);
  CommandInt command;
  command.command = kDoReposition;
  command.target_system = 1;
  command.target_component = kCompanionComponent;
  command.frame = kLocalNed;
  command.x = 15000;
  command.z = -4.0f;
  goal = goal_of(command, nullptr);
  EXPECT_NEAR(goal.goal.y, 1.5, kClose);
  EXPECT_EQ(goal.goal.z, 4.0);
  EXPECT_EQ(goal.command, kDoReposition);
  command.frame = kGlobalInt;
  EXPECT_EQ(goal_of(command, nullptr).kind, Kind::kRefused) << "the origin is not known";
  const GpsGlobalOrigin origin{600000000, 100000000, 50000, 0};
  command.x = origin.latitude + 899;  // 10 m north, 10 m east at 60 degrees
  command.y = origin.longitude + 1799;
  command.z = 55.0f;
  const LocalFrame local{origin, Projection::kAzimuthal};
  goal = goal_of(command, &local);
  EXPECT_NEAR(goal.goal.x, 10.0, 0.02);
  EXPECT_NEAR(goal.goal.y, 10.0, 0.02);
  EXPECT_NEAR(goal.goal.z, 5.0, kClose);
  command.x = origin.latitude + 1000000;
  goal = goal_of(command, &local);
  EXPECT_EQ(goal.kind, Kind::kRefused);
  EXPECT_NE(goal.reason.find("10 km"), std::string::npos);
  CommandLong pause;
  pause.command = 193;
  pause.target_system = 1;
  pause.target_component = kCompanionComponent;
  EXPECT_EQ(goal_of(pause, nullptr).kind, Kind::kStop);
  pause.params[0] = 1.0f;
  EXPECT_EQ(goal_of(pause, nullptr).kind, Kind::kContinue);
}

std::string fault_of(const std::string& text) {
  std::istringstream file(text);
  try {
    read_mission(file, "m.txt");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(CompanionMission, FilesAreRead) {
  std::istringstream file("# a round\nvia 1 2 3 0.5\n\nvia 4 5 6 dwell 2  # look\ngoal 0 0 2\n");
  const std::vector<tern::Via> points = read_mission(file, "m.txt");
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].tolerance, 0.5);
  EXPECT_TRUE(points[1].stop);
  EXPECT_EQ(points[1].dwell, 2.0);
  EXPECT_EQ(points[2].position.z, 2.0);
  EXPECT_EQ(fault_of("via 1 2\ngoal 0 0 2\n"), "m.txt:1: via needs three numbers: EAST NORTH UP, in metres");
  EXPECT_EQ(fault_of("goal 0 0 2\nvia 1 2 3\n"), "m.txt:2: the goal is the last line");
  EXPECT_EQ(fault_of("via 1 2 3 fast\n"),
            "m.txt:1: 'fast' is not known here; after the point come [TOLERANCE] [stop] [dwell SECONDS]");
  EXPECT_EQ(fault_of("via 1 2 3\n"), "m.txt: no goal; its last line is 'goal EAST NORTH UP'");
}

TEST(CompanionTransport, AddressesAreRefusedWithAReason) {
  for (const char* address : {"udp", "udp:", "udp:0", "udp:70000", "tcp:5760", "serial:/dev/null", "serial::57600"}) {
    EXPECT_THROW(open_transport(address), std::runtime_error) << address;
  }
  EXPECT_THROW(open_transport("serial:/dev/null:1234"), std::runtime_error);
  EXPECT_THROW(open_transport("serial:/dev/null:57600"), std::runtime_error) << "no serial port";
}

}  // namespace
}  // namespace tern_companion
