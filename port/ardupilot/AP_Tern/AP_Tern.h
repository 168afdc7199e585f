// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A library for ArduPilot that plans on board and flies the plan in guided mode. It calls Tern's C interface, which has
// no floating-point constants that ArduPilot's -fsingle-precision-constant could change.
#pragma once

#include <AP_Math/AP_Math.h>
#include <tern/tern_export.h>

class AP_Tern {
 public:
  enum class State : uint8_t { IDLE, PLANNING, FLYING, ARRIVED, FAILED };

  /// Memory is the caller's: the workspace, tern_size_of(TERN_SIZE_WORKSPACE) bytes, and the grid's words.
  AP_Tern(void* workspace, size_t bytes, uint64_t* words, size_t word_count);

  /// Makes the map: obstacles are boxes, east, north, up from the EKF's origin, metres. Call it on the ground.
  bool set_map(const tern_grid_spec& spec, const tern_box* boxes, uint8_t count);
  /// Begins to plan from rest at `here_ned`, where the vehicle hovers, to rest at `goal_ned`; metres from the EKF's
  /// origin. AP_AHRS has the position, under names that changed: get_relative_position_NED_origin() and ..._float().
  bool fly_to(const Vector3f& here_ned, const Vector3f& goal_ned);
  /// A slice of the plan, or the next setpoint. A scheduler task at 50 Hz.
  void update();
  State state() const { return state_; }
  /// Why there is no plan.
  const char* status() const { return tern::status_name(report_.status); }

  /// ArduPilot's limits, in metres; by default those of a copter. Set what the vehicle has.
  tern_ardupilot_parameters parameters;

 private:
  void plan_slice();
  void send_setpoint();

  State state_ = State::IDLE;
  bool usable_ = false;
  uint64_t* words_;
  size_t word_count_;
  uint64_t begin_us_ = 0;
  tern_grid grid_{};  // zeros: fly_to() may come before set_map()
  tern_planner planner_;
  tern_request request_;
  tern_report report_{};
  tern_trajectory plan_;
};
