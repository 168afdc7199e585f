// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A node's record beside what the node sent.
#ifndef TERN_TESTS_PORTS_ROS2_REPLAYED_FLIGHT_HPP
#define TERN_TESTS_PORTS_ROS2_REPLAYED_FLIGHT_HPP

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "host/flight/flight_replay.hpp"
#include "ros2/camera_world.hpp"

namespace tern_test {

/// Flies the record of a flight again: what each tick commands is what was sent for it, bit for bit.
inline void expect_replays(const std::filesystem::path& file, const CameraWorld& world) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  int different = 0;
  const auto equal = [](const auto& a, const tern::Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  const tern_host::FlightReplay replay = tern_host::replay_flight(bytes, [&](const tern_host::ReplayedTick& tick) {
    const auto sent = world.sent.find(tick.t);
    const bool same = sent != world.sent.end() &&
                      equal(sent->second.transforms.at(0).translation, tick.command.sample.position) &&
                      equal(sent->second.velocities.at(0).linear, tick.command.sample.velocity) &&
                      equal(sent->second.accelerations.at(0).linear, tick.command.sample.acceleration);
    different += same ? 0 : 1;
  });
  EXPECT_EQ(replay.difference, "");
  EXPECT_EQ(different, 0);
  EXPECT_GT(replay.ticks, 500);
  EXPECT_GT(replay.frames, 50);
}

}  // namespace tern_test

#endif
