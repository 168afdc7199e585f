// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two vehicles agree through ROS messages, here the stand-ins of ROS 2; those of ROS 1 have the same fields.
#include <gtest/gtest.h>

#include <memory>
#include <std_msgs/msg/u_int8_multi_array.hpp>
#include <vector>

#include "tern_ros/fleet_packets.hpp"

namespace {

using Message = std_msgs::msg::UInt8MultiArray;
constexpr std::int64_t kSecond = 1000000000;

std::unique_ptr<tern::Fleet> at_rest(std::uint16_t id, double x) {
  tern::Trajectory rest{};
  rest.count = 1;
  rest.origin = {x, 0, 0};
  rest.segments[0].duration = 1.0;
  tern::FleetSpec spec;
  spec.id = id;
  spec.incarnation = 1;
  spec.radius = 0.3;
  spec.tick = kSecond / 10;
  auto fleet = std::make_unique<tern::Fleet>();
  EXPECT_EQ(fleet->begin(spec, rest, 0), tern::Status::kOk);
  EXPECT_EQ(fleet->add(static_cast<std::uint16_t>(3 - id), 0), tern::Status::kOk);
  return fleet;
}

TEST(RosFleet, AgreesThroughMessages) {
  const std::unique_ptr<tern::Fleet> fleets[2] = {at_rest(1, 0.0), at_rest(2, 5.0)};
  tern::Trajectory plan = *fleets[1]->flown();
  plan.begin = 3 * kSecond;
  int messages = 0;
  for (int tick = 1; tick <= 40; ++tick) {
    const std::int64_t now = tick * kSecond / 10;
    if (tick == 10) {
      EXPECT_EQ(fleets[1]->announce(plan, plan.begin, now), tern::Status::kOk);
    }
    for (int v = 0; v < 2; ++v) {
      tern::Work work(1000);
      fleets[v]->advance(now, work);
      tern_ros::publish_round<Message>(*fleets[v], [&](const Message& message) {
        ++messages;
        EXPECT_TRUE(message.layout.dim.empty());
        const tern::Heard heard = tern_ros::receive(*fleets[1 - v], message, now);
        EXPECT_TRUE(heard == tern::Heard::kNews || heard == tern::Heard::kOld);
      });
    }
  }
  EXPECT_EQ(fleets[1]->report().announcement, tern::Announcement::kTaken);
  EXPECT_GT(messages, 80);
}

TEST(RosFleet, RefusesMessagesThatAreNoPackets) {
  const std::unique_ptr<tern::Fleet> fleet = at_rest(1, 0.0);
  Message message;
  EXPECT_EQ(tern_ros::receive(*fleet, message, 0), tern::Heard::kDamaged);
  message.data.assign(70000, 17);
  EXPECT_EQ(tern_ros::receive(*fleet, message, 0), tern::Heard::kDamaged);
}

}  // namespace
