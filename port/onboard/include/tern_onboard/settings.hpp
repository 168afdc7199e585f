// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What an operator sets, with its defaults. The table of parameters (parameters.hpp) has the units, the ranges and what
// each one means.
#ifndef TERN_ONBOARD_SETTINGS_HPP
#define TERN_ONBOARD_SETTINGS_HPP

#include <cstdint>
#include <string>

#include "tern/vec3.hpp"

namespace tern_onboard {

/// The rolling map. Numbers that count something are whole; they are doubles because parameters are.
struct MapSettings {
  double cell = 0.2;
  tern::Vec3 window = {51.2, 30.0, 8.0};
  double radius = 0.35;
  double tracking_margin = 0.3;
  double range = 8.0;
  double depth_margin = 0.05;
  double depth_margin_square = 0.0;
  double pose_margin = 0.05;
  double angle_margin = 0.02;
  double scan_pixel = 0.04;
  double image_pixels = 320 * 240;
  double hits = 1;
  double misses = 3;
  double support = 0;
  double age = 0.0;
  double free_radius = 2.0;
};

/// Plans, brakes and the nose.
struct FlySettings {
  double speed = 2.0;
  double climb = 1.0;
  double sink = 1.0;
  double acceleration = 2.0;
  double acceleration_z = 2.0;
  double jerk = 4.0;
  double time_weight = 1000.0;
  double horizon = 6.0;
  double ground = -1000.0;
  double ceiling = 1000.0;
  std::string yaw = "unseen";
  double yaw_rate = 1.0;
  double yaw_acceleration = 2.0;
  double field_of_view = 1.2;
  double view_height = 1.0;
  double view_pitch = 0.0;
  double view_raised = 0.0;
  double tick_rate = 100.0;
  double work_per_tick = 4000;
  double plan_work = 16000;
};

/// When something is too old, too far off or missing.
struct WatchSettings {
  double pose_age = 0.3;
  double pose_gap = 0.15;
  double pose_jump = 0.5;
  double heading_jump = 0.5;
  double frame_age = 0.5;
  double stale_after = 1.0;
  double stray = 1.5;
  bool slow_when_straying = true;
};

/// Things that move, as others report them.
struct ThingSettings {
  double sigmas = 4.0;
  double memory = 10.0;
  double range = 1000.0;
  double beyond_speed = 0.0;
  double beyond_size = 1.0;
  double detector_range = 20.0;
  double detector_delay = 0.2;
  std::string clusters = "none";
};

struct Settings {
  MapSettings map;
  FlySettings fly;
  WatchSettings watch;
  ThingSettings things;
};

/// One sensor's numbers; its kind, mounting and lens come with SensorSpec (sensors.hpp).
struct SensorSettings {
  double least = 0.2;
  double most = 20.0;
  double no_return = 0.0;
  double time_offset = 0.0;
};

}  // namespace tern_onboard

#endif
