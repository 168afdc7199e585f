// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A world to be discovered in flight, and how it is flown: a scenario file whose blocks and cylinders are the truth.
#ifndef TERN_HOST_FLIGHT_FLIGHT_WORLD_HPP
#define TERN_HOST_FLIGHT_FLIGHT_WORLD_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/earth_frame.hpp"
#include "host/fence_cover.hpp"
#include "host/fence_record.hpp"
#include "host/flight/sensor_mount.hpp"
#include "host/things/thing.hpp"
#include "host/vehicle/air.hpp"
#include "host/vehicle/pose_error.hpp"
#include "tern/flight.hpp"
#include "tern/track_class.hpp"
#include "tern/vec3.hpp"
#include "tern/via.hpp"

namespace tern_host {

/// An upright cylinder between two heights.
struct Cylinder {
  double x, y, bottom, top, radius;
};

/// The longest that a flight may take, seconds; what ends then, never does.
constexpr double kLongestFlight = 1e4;

/// Ticks that are not done: a share of all, in runs of up to so many.
struct TickSkips {
  double share = 0.0;
  int longest = 1;
};

/// A goal that is somewhere else at every tick: up to `size` metres away along x and y, until so many seconds.
struct GoalJitter {
  double size = 0.0;
  double until = kLongestFlight;
};

/// A pillar that appears on the way: once the vehicle moves at this time or later, so many metres before it.
struct AppearAhead {
  double time = 0.0;      ///< seconds
  double distance = 0.0;  ///< metres of way; 0: none appears
};

/// A further camera: how far it is turned to the left of the vehicle's sensor and pitched up from it, rad.
struct FurtherCamera {
  double turn = 0.0;
  double pitch = 0.0;
};

/// The largest error of a depth z: base + square * z * z. Metres, and 1 / metre.
struct DepthError {
  double base = 0.0;
  double square = 0.0;

  double at(double depth) const { return base + square * depth * depth; }
};

/// One record each in a world's file, and a key of `--set`. SI units, angles in rad.
struct FlightSettings {
  double body_radius = 0.25;
  double tracking_margin = 0.10;  ///< largest error of the vehicle, which is flown
  double pose_margin = 0.0;
  double depth_margin = 0.02;
  double cell = 0.0;              ///< 0 in a file that does not say: by the boundary's height
  tern::Vec3 window{};            ///< likewise; its height is the boundary's where that is less
  std::string sensor = "camera";  ///< or lidar
  double scan_pixel = 0.04;       ///< as MapSpec::scan_pixel, for the lidar
  int beams = 0;                  ///< of a lidar that scatters them (lidar.hpp); 0: it has rows of them
  double sensor_range = 10.0;
  double sensor_min = 0.1;                     ///< nearest depth that the camera measures
  double sensor_far = 0.0;                     ///< farther things give the camera no depth; 0: all do
  double fov_horizontal = 1.5707963267948966;  ///< of the camera; the lidar sees all around, and may say 2 pi
  double fov_vertical = 1.2915436464758039;
  int width = 160;
  int height = 120;
  double sensor_hz = 30.0;
  double sensor_latency = 0.033;
  SensorMount mount;  ///< of the camera
  std::vector<FurtherCamera> cameras;
  double pixel_part = 1.0;   ///< how much of a pixel's width and height the camera sees: as depths_of_faces()
  double no_return = 0.0;    ///< as DepthView::no_return, for the camera
  double depth_noise = 0.0;  ///< largest error, metres a metre of depth
  DepthError depth_error;    ///< and what comes on top
  double holes = 0.0;        ///< part of the camera's image that has no depth, in round patches
  double dropout = 0.0;      ///< part of the frames that are lost
  double outliers = 0.0;     ///< part of the pixels with a random depth
  int hits = 0;              ///< as MapSpec::hits; 0 in a file that does not say: 2 with outliers, unfiltered, else 1
  int support = -1;          ///< as MapSpec::support; negative in a file that does not say: likewise 1, else 0
  int speckle_filter = -1;   ///< 1: the sensor's driver takes lone pixels out; negative: with outliers
  double v_max = 3.0;
  double a_max = 6.0;
  double j_max = 0.0;       ///< 0: no limit
  double thrust_max = 0.0;  ///< these four as in tern::Limits
  double thrust_min = 0.0;
  double tilt_tangent = 0.0;
  double rate_max = 0.0;
  double yaw_rate = 2.5;
  double yaw_acceleration = 8.0;  ///< rad/s^2; only where the flight plans its yaw
  std::string yaw = "gimbal";     ///< or the flight's own plan: unseen, motion, point or heading
  tern::Vec3 yaw_point{};
  double yaw_heading = 0.0;  ///< rad
  double tick_hz = 100.0;
  int work_per_tick = 4000;
  double time_limit = 120.0;
  double far_cell = 0.0;  ///< of the coarse grid that leads the flight (far_guide.hpp), metres; 0: none does
  double goal_tolerance = 0.01;
  std::string tracking = "bounded";  ///< a kind of vehicle (vehicle.hpp)
  int monitor = -1;                  ///< 1: the flight is told where the vehicle is; negative in a file that does not
                                     ///< say: under a flight stack
  Air air;                           ///< for rigid bodies
  double stack_speed = 12.0;         ///< MPC_XY_VEL_MAX of "px4", WPNAV_SPEED of "ardupilot", m/s
  std::uint64_t seed = 1;

  // What the flight is told of things that move.
  int things = 1;       ///< 0: there are none, as if the world's file had no such records
  int things_seen = 0;  ///< 1: cameras and lidars see them
  /// "truth": the simulator measures them; "clusters": cameras and lidars do, by what hits where the map saw free
  /// space.
  std::string detection_source = "truth";
  tern::TrackClass cluster_class = tern::TrackClass::kPerson;  ///< what clusters are taken for
  double thing_memory = 0.0;  ///< a track not measured for longer, s, is forgotten; 0: none is
  double detection_hz = 10.0;
  double detection_latency = 0.05;     ///< s
  double detection_error = 0.03;       ///< largest error of a place, m
  double detection_speed_error = 0.1;  ///< and of a velocity, m/s
  double detection_range = 22.0;       ///< of a thing's centre, m
  double detection_misses = 0.0;       ///< part of the measurements that are lost
  double detection_swaps = 0.0;        ///< part of the measurements in which two things change names
  int detection_occlusion = 0;         ///< 1: what is behind an obstacle is not seen
  double beyond_speed = 0.0;           ///< of what may come from beyond the detector's range, m/s; 0: nothing does
  double beyond_size = 0.0;            ///< from its centre to its farthest point, m
  double thing_bounds = 1.0;           ///< what the flight is told of a thing's bounds, as a part of what is true

  // Faults.
  double frames_until = kLongestFlight;  ///< seconds; no frame is taken later
  PoseJumps pose_jump;                   ///< of the estimated position
  double pose_drift = 0.0;               ///< of the estimated position, m/s
  double pose_lag = 0.0;                 ///< how old the estimates are that rigid bodies are flown by, seconds
  TickSkips tick_skip;
  GoalJitter goal_jitter;
  AppearAhead appear_ahead;
  std::string goal_place = "given";  ///< or occupied, in the nearest obstacle; or outside the boundary
};

/// An obstacle that is not there from the beginning.
struct Appearance {
  double time;  ///< seconds
  bool is_block;
  tern::Box block;
  Cylinder cylinder;
};

/// Where a world says what it asks for; the file alone where a record is missing.
struct PointPlaces {
  Place start;
  Place goal;
  Place column;
  std::vector<Place> vias;
};

/// How to land at the goal.
struct GoalOnGround {
  double ground = 0.0;  ///< the height that the ground there does not exceed, metres
  double speed = 0.0;   ///< of the descent, m/s; 0: the goal is in the air
};

struct FlightWorld {
  std::string name;  ///< the file's
  std::vector<tern::Box> blocks;
  std::vector<std::size_t> unmapped;  ///< blocks that a coarse grid of the world does not know
  std::vector<Cylinder> cylinders;
  std::vector<Appearance> appearing;
  std::vector<Thing> things;  ///< that move
  EarthFrame earth;           ///< where on the earth the world frame is, if the file says so
  tern::Box boundary{};       ///< its faces are walls
  tern::Vec3 start{};
  tern::Vec3 goal{};
  tern::Cylinder column{};  ///< as for RollingMap::assume_column(), for a start on the ground; a radius of 0: none
  GoalOnGround landing;
  std::vector<FenceRecord> fences;
  std::optional<FenceCover> fences_within;  ///< what the fences were made for, if the file says so
  std::vector<tern::Via> vias;              ///< points to pass on the way to the goal
  tern::ViaPolicy via_policy = tern::ViaPolicy::kEnd;
  FlightSettings settings;
  PointPlaces places;
  std::vector<std::string> warnings;  ///< records that add nothing to the world, each with its place
};

/// The vias, and the goal as the last one.
std::vector<tern::Via> mission_of(const FlightWorld& world);

/// The world with what appeared in it.
FlightWorld with_appeared(FlightWorld world, const std::vector<Appearance>& appeared);

/// Reads a world's file, or makes the world that `path` names (world_family.hpp). `overrides` are `key=value` with
/// commas between numbers, and win. Throws RecordError.
FlightWorld read_flight_world(const std::string& path, const std::vector<std::string>& overrides);

/// `defaults` with `overrides`, for what has no world. Throws RecordError.
FlightSettings flight_settings(const std::vector<std::string>& overrides, const FlightSettings& defaults = {});

/// Distance of a point from an obstacle, metres; 0 inside.
double distance_to(const tern::Box& block, const tern::Vec3& point);
double distance_to(const Cylinder& cylinder, const tern::Vec3& point);
double distance_to(const Appearance& appearance, const tern::Vec3& point);

/// Distance of a point from the nearest face of a box that it is in, metres; negative outside.
double room_within(const tern::Box& box, const tern::Vec3& point);

/// Distance of a point from the nearest block, cylinder or wall, metres; negative outside the boundary.
double clearance(const FlightWorld& world, const tern::Vec3& point);

}  // namespace tern_host

#endif
