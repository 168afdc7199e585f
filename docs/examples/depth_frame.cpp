// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/map.md: a depth frame of a wall 4 m ahead enters the map.
#include <cmath>
#include <cstdint>
#include <vector>

#include "tern/tern.hpp"

/// The pose of a level camera that looks along `yaw`, in radians from x of the world.
static tern::Pose level_camera(const tern::Vec3& position, double yaw) {
  const double c = 0.5 * std::cos(0.5 * yaw);
  const double s = 0.5 * std::sin(0.5 * yaw);
  return {position, {c + s, -c - s, c - s, s - c}};  // (w, x, y, z); along x: (0.5, -0.5, 0.5, -0.5)
}

static tern::Status enter_frame(tern::RollingMap& map, const std::uint16_t* millimetres, const tern::Pose& pose,
                                std::int64_t now) {
  tern::DepthView view{};
  view.z16 = millimetres;
  view.width = 160;
  view.height = 120;
  view.stride = 160;  // numbers from one row to the next
  view.fx = view.fy = 80.0;
  view.cx = 79.5;
  view.cy = 59.5;
  view.scale = 0.001;  // metres a unit
  view.min = 0.2;
  view.max = 10.0;
  tern::Status status = map.begin_frame(view, pose, now);
  while (status == tern::Status::kRunning) status = map.step(1000);
  return status;
}

int main() {
  const tern::MapSpec spec = tern::map_spec({-12.8, -6.4, 0.0}, 0.2, {128, 64, 16}, 0.35);
  std::vector<std::uint64_t> words(tern::map_words(spec));
  tern::RollingMap map;
  if (map.bind(spec, words.data(), words.size()) != tern::Status::kOk) return 1;
  const std::vector<std::uint16_t> wall(160 * 120, 4000);
  const double quarter = std::acos(0.0);
  if (enter_frame(map, wall.data(), level_camera({0.0, 0.0, 1.5}, 0.0), 0) != tern::Status::kOk) return 1;
  if (enter_frame(map, wall.data(), level_camera({0.0, 0.0, 1.5}, quarter), 33000000) != tern::Status::kOk) return 1;

  const tern::Voxel ahead{74, 32, 7}, wall_ahead{84, 32, 7}, left{64, 42, 7}, wall_left{64, 52, 7}, behind{54, 32, 7};
  const bool sees_free = map.seen(ahead) && map.seen(left) && !map.seen(behind);
  const bool sees_walls = map.route().obstacle(wall_ahead) && map.route().obstacle(wall_left);
  return sees_free && sees_walls ? 0 : 1;
}
