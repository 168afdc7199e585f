// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning.hpp"

#include <parameters/param.h>
#include <px4_platform_common/log.h>

namespace tern_offboard {
namespace {

// Memory. All of it is fixed here; a world that needs more is refused.
constexpr int32_t kVoxels = tern::kMaxCells < 524288 ? static_cast<int32_t>(tern::kMaxCells) : 524288;
constexpr int32_t kPixels = 4096;  // of scans: 6 * (2.5 / kScanPixel)^2 at least
constexpr size_t kMapWords = kVoxels / 8 + kVoxels / 512 + kPixels / 2 + 1024;
// A grid and the layers of lookouts; the state, with its plans and what they keep of things that move.
constexpr size_t kFlightWords = kVoxels / 32 + kVoxels / 2048 + kVoxels / 56 + 4800 + 285 * tern::kMaxSegments +
                                100 * tern::kMaxFlightTracks + 25 * tern::kMaxFlightPieces;

// How it flies.
constexpr double kHeights = 0.3;          // m above and below start and goal that a flight with sensors uses
constexpr double kHorizon = 6.0;          // m that plans lead ahead
constexpr double kDepthMargin = 0.1;      // m, error of a range
constexpr double kPoseMargin = 0.15;      // m, of the place that it was measured from, with the delay
constexpr double kAngleMargin = 0.05;     // rad, likewise
constexpr double kYawRate = 1.0;          // rad/s
constexpr double kYawAcceleration = 1.0;  // rad/s^2
constexpr uint32_t kWorkPerTick = 1500;   // thousands of instructions of Tern in 20 ms

tern::Workspace workspace;  // too large for a task's stack
uint64_t map_words[kMapWords];
uint64_t flight_words[kFlightWords];
World world;
tern::MapSpec spec;
tern::RollingMap map;
tern::Flight flight;
tern::Limits limits;
tern::Halfspace planes[tern::kBoxPlanes];
tern::Fence fence;

tern::Planner& planner() {
  static tern::Planner only(&workspace, sizeof workspace);
  return only;
}

double parameter(const char* name, double otherwise) {
  float value = 0.f;
  return param_get(param_find(name), &value) == 0 ? static_cast<double>(value) : otherwise;
}

/// Lowers the limits of each axis to `most`. A lower limit of 0 is minus the upper one.
void lower(const tern::Vec3& most, tern::Vec3& upper, tern::Vec3& least) {
  upper = {fmin(upper.x, most.x), fmin(upper.y, most.y), fmin(upper.z, most.z)};
  least = {fmax(least.x, -most.x), fmax(least.y, -most.y), fmax(least.z, -most.z)};
}

bool read_limits() {
  tern::Px4Limits own = tern::px4_limits();
  own.mpc_xy_vel_max = parameter("MPC_XY_VEL_MAX", own.mpc_xy_vel_max);
  own.mpc_z_vel_max_up = parameter("MPC_Z_VEL_MAX_UP", own.mpc_z_vel_max_up);
  own.mpc_z_vel_max_dn = parameter("MPC_Z_VEL_MAX_DN", own.mpc_z_vel_max_dn);
  own.mpc_acc_hor = parameter("MPC_ACC_HOR", own.mpc_acc_hor);
  own.mpc_acc_up_max = parameter("MPC_ACC_UP_MAX", own.mpc_acc_up_max);
  own.mpc_acc_down_max = parameter("MPC_ACC_DOWN_MAX", own.mpc_acc_down_max);
  own.mpc_jerk_auto = parameter("MPC_JERK_AUTO", own.mpc_jerk_auto);
  own.mpc_tiltmax_air = parameter("MPC_TILTMAX_AIR", own.mpc_tiltmax_air);
  own.mpc_thr_hover = parameter("MPC_THR_HOVER", own.mpc_thr_hover);
  own.mpc_thr_min = parameter("MPC_THR_MIN", own.mpc_thr_min);
  own.mpc_thr_max = parameter("MPC_THR_MAX", own.mpc_thr_max);
  own.mc_rollrate_max = parameter("MC_ROLLRATE_MAX", own.mc_rollrate_max);
  own.mc_pitchrate_max = parameter("MC_PITCHRATE_MAX", own.mc_pitchrate_max);
  tern::Field field = tern::Field::kNone;
  const tern::Status status = tern::limits_from_px4(own, limits, &field);
  if (status != tern::Status::kOk) {
    PX4_ERR("PX4's parameters give no limits: %s, %s", tern::status_name(status), tern::field_name(field));
    return false;
  }
  lower(world.v_max, limits.v_max, limits.v_min);
  lower(world.a_max, limits.a_max, limits.a_min);
  limits.v_horizontal = fmin(limits.v_horizontal, world.v_horizontal);
  return true;
}

/// The window of the map: the boundary, and what is around it. Rows along x take 64 voxels at a time, and plans lead no
/// further than half of the window along x.
void lay_window() {
  const double keeps = world.radius + world.tracking_margin + 2.0 * world.resolution;
  const tern::Vec3 a = world.boundary.lower;
  const tern::Vec3 b = world.boundary.upper;
  const tern::Vec3 middle = {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)};
  const auto voxels = [&](double size) { return static_cast<int32_t>(ceil((size + 2.0 * keeps) / world.resolution)); };
  const tern::Voxel dims = {(voxels(b.x - a.x) + 63) / 64 * 64, voxels(b.y - a.y), voxels(b.z - a.z)};
  const double half = 0.5 * world.resolution;
  const tern::Vec3 origin = {middle.x - half * dims.x, middle.y - half * dims.y, middle.z - half * dims.z};
  spec = tern::map_spec(origin, world.resolution, dims, world.radius);
  spec.tracking_margin = world.tracking_margin;
  spec.range = kRange;
  spec.depth_margin = kDepthMargin;
  spec.pose_margin = kPoseMargin;
  spec.angle_margin = kAngleMargin;
  spec.scan_pixel = kScanPixel;
  spec.slack = tern::kMaxDimension;  // the window stays where it is
  spec.pixels = kPixels;
  spec.prior = world.blocks;
  spec.prior_count = world.block_count;
}

bool make_map() {
  lay_window();
  const size_t needed = tern::map_words(spec);
  tern::Field field = tern::Field::kNone;
  const tern::Status status = map.bind(spec, map_words, kMapWords, &field);
  if (status != tern::Status::kOk || tern::flight_words(spec.dims) > kFlightWords) {
    PX4_ERR("no map of %d x %d x %d voxels: %s, %s; it needs %u of %u words", static_cast<int>(spec.dims.x),
            static_cast<int>(spec.dims.y), static_cast<int>(spec.dims.z), tern::status_name(status),
            tern::field_name(field), static_cast<unsigned>(needed), static_cast<unsigned>(kMapWords));
    return false;
  }
  const tern::Vec3 size = {spec.cell * spec.dims.x, spec.cell * spec.dims.y, spec.cell * spec.dims.z};
  const tern::Vec3 middle = {spec.origin.x + 0.5 * size.x, spec.origin.y + 0.5 * size.y, spec.origin.z + 0.5 * size.z};
  return map.assume_free(middle, length(size)) == tern::Status::kOk;
}

/// The vehicle's centre stays in the world and, with sensors, near the heights that they look at.
void lay_fence(double from, double to, bool has_sensors) {
  tern::Box box = world.boundary;
  if (has_sensors) {
    box.lower.z = fmax(box.lower.z, fmin(from, to) - kHeights);
    box.upper.z = fmin(box.upper.z, fmax(from, to) + kHeights);
  }
  tern::box_planes(box, planes);
  fence = {planes, tern::kBoxPlanes, tern::FenceKind::kKeepIn};
}

bool is_goal_free(const tern::Vec3& goal) {
  const double scale = 1.0 / spec.cell;
  const tern::Voxel voxel = {static_cast<int32_t>(floor(scale * (goal.x - spec.origin.x))),
                             static_cast<int32_t>(floor(scale * (goal.y - spec.origin.y))),
                             static_cast<int32_t>(floor(scale * (goal.z - spec.origin.z)))};
  const tern::Box& box = world.boundary;
  return goal.x >= box.lower.x && goal.x <= box.upper.x && goal.y >= box.lower.y && goal.y <= box.upper.y &&
         goal.z >= box.lower.z && goal.z <= box.upper.z && map.route().free(voxel);
}

}  // namespace

bool begin_flight(const Hover& from, const tern::Vec3& goal, bool has_sensors, bool new_map, hrt_abstime now) {
  if (new_map && !make_map()) return false;
  while (map.busy()) map.step(1000u);  // a measurement of the flight before
  lay_fence(from.position.z, goal.z, has_sensors);
  tern::FlightSpec how = tern::flight_spec(limits);
  how.tick = kTick;
  how.work_per_tick = kWorkPerTick;
  how.horizon = fmin(kHorizon, 0.45 * spec.cell * spec.dims.x);
  how.yaw_rate = kYawRate;
  how.fences = &fence;
  how.fence_count = 1;
  how.stale_after = 0;  // the map is known, and the module watches the sensors
  tern::FlightRefusal why;
  const tern::Status status =
      flight.start(how, map, planner(), flight_words, kFlightWords, from.position, nanoseconds(now), &why);
  if (status != tern::Status::kOk) {
    PX4_ERR("no flight from here: %s, %s", tern::status_name(status), tern::field_name(why.field));
    if (why.blocked_by == tern::BlockedBy::kNothing) return false;
    PX4_ERR("%s at %.2f %.2f %.2f is %.2f m away, and must be %.2f m", tern::blocked_by_text(why.blocked_by),
            why.blocked_at.x, why.blocked_at.y, why.blocked_at.z, why.distance, why.needed);
    return false;
  }
  tern::FlightYaw yaw{};
  yaw.mode = tern::FlightYawMode::kAlongMotion;  // a sensor that looks ahead sees where the vehicle goes
  yaw.acceleration_max = kYawAcceleration;
  yaw.start = {sin(from.heading), cos(from.heading)};
  return flight.set_yaw(yaw) == tern::Status::kOk && flight.set_goal(goal) == tern::Status::kOk;
}

bool prepare(const char* map_path, const Hover& from, const tern::Vec3& goal, hrt_abstime now) {
  if (!read_world(map_path, world) || !read_limits() || !begin_flight(from, goal, false, true, now)) return false;
  if (is_goal_free(goal)) return true;
  PX4_ERR("the goal is outside the boundary, or too near to a block");
  return false;
}

tern::Flight& the_flight() {
  return flight;
}

tern::RollingMap& the_map() {
  return map;
}

}  // namespace tern_offboard
