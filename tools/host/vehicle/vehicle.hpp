// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What truly flies. A vehicle follows commands as well as it can; how far it is off them is its tracking error.
#ifndef TERN_HOST_VEHICLE_VEHICLE_HPP
#define TERN_HOST_VEHICLE_VEHICLE_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/vehicle/air.hpp"
#include "host/vehicle/pose_error.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// What a vehicle is told to fly at one time. World frame.
struct Setpoint {
  tern::Sample sample;
  double yaw;       ///< rad, counter-clockwise from x
  double yaw_rate;  ///< rad/s
};

/// The setpoint at a time in seconds. A vehicle asks for times up to its own time and its motors' lag.
using Setpoints = std::function<Setpoint(double)>;

class Vehicle {
 public:
  virtual ~Vehicle() = default;
  /// Flies on to time `t`, seconds since the beginning.
  virtual void fly_to(double t, const Setpoints& setpoints) = 0;
  /// Where it truly is, and how fast it moves. World frame.
  virtual tern::Vec3 position() const = 0;
  virtual tern::Vec3 velocity() const = 0;
  /// How it is turned: the unit quaternion (w, x, y, z) from its axes (x ahead, y left, z along its thrust) to the
  /// world's.
  virtual std::array<double, 4> attitude() const = 0;
  /// Where it believes to be.
  virtual tern::Vec3 estimate() const = 0;
};

struct VehicleSettings {
  std::string kind;            ///< one of vehicle_kinds()
  double tracking_margin = 0;  ///< of "bounded": its largest error, metres
  double pose_margin = 0;      ///< largest error of the estimate, metres, but for jumps beyond it
  PoseJumps pose_jumps;        ///< of the estimate
  double pose_drift = 0;       ///< of the estimate, m/s
  double pose_lag = 0;         ///< how old the estimates are that rigid bodies are flown by, seconds
  Air air;                     ///< for the rigid bodies
  double stack_speed = 12;     ///< MPC_XY_VEL_MAX of "px4", WPNAV_SPEED of "ardupilot", m/s
  double tick = 0.01;          ///< seconds from one setpoint to the next, where they come as a stream
  std::uint64_t seed = 1;
};

/// perfect: no error. bounded: a smooth, seeded error. quadrotor: a rigid body under a geometric controller. px4 and
/// ardupilot: the same body under the cascades of the two stacks.
const std::vector<std::string>& vehicle_kinds();

/// True for the kinds that are rigid bodies.
bool is_rigid_body(const std::string& kind);

/// True for the kinds that have a flight stack's cascade.
bool is_stack(const std::string& kind);

/// A vehicle that believes to hover at a setpoint at time 0: it is off that by the estimate's error. Stacks have
/// hovered there in the wind for 30 s, so that their integrators are settled.
std::unique_ptr<Vehicle> make_vehicle(const VehicleSettings& settings, const Setpoint& start);

}  // namespace tern_host

#endif
