// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A library for ArduPilot that plans on board and flies the plan in guided mode. It calls Tern's C interface, which has
// no floating-point constants that ArduPilot's -fsingle-precision-constant could change. UserCode.cpp shows how to call
// it.
#pragma once

#include <AP_Math/AP_Math.h>
#include <tern_stacks/stacks.h>

class AP_Tern {
 public:
  enum class State : uint8_t { IDLE, PLANNING, FLYING, STOPPING, ARRIVED, FAILED };

  /// What the vehicle does at an update. North, east, down from the EKF's origin, metres.
  struct Vehicle {
    bool ready;  ///< in guided mode, armed, in the air, with a valid estimate
    Vector3f position, velocity;
  };

  /// Memory is the caller's: the workspace, tern_size_of(TERN_SIZE_WORKSPACE) bytes, and the grid's words.
  AP_Tern(void* workspace, size_t bytes, uint64_t* words, size_t word_count);

  /// Makes the map: obstacles are boxes, east, north, up from the EKF's origin, metres. Call it on the ground.
  bool set_map(const tern_grid_spec& spec, const tern_box* boxes, uint8_t count);
  /// Plans to rest at `goal_ned` from where the vehicle rests at the next updates, and flies there. False: not usable,
  /// in flight, or parameters that give no limits.
  bool fly_to(const Vector3f& goal_ned);
  /// A slice of the plan, or the next setpoint. A scheduler task at 50 Hz, also after the arrival: ArduPilot goes on
  /// with the last velocity that it was told.
  void update(const Vehicle& now);
  /// Comes to rest along the plan. Updates must go on.
  void stop();

  State state() const { return state_; }
  /// Why there is no plan.
  const char* status() const { return tern::status_name(report_.status); }
  /// Why a flight ended or stops, or an empty string.
  const char* reason() const { return reason_; }

  /// ArduPilot's limits, in metres; by default those of a copter. Set what the vehicle has.
  tern_ardupilot_parameters parameters;

 private:
  void plan(const Vehicle& now);
  void fly(const Vehicle& now, uint64_t step_us);
  void slow_down(const char* reason);
  void advance(uint64_t step_us);
  void send_setpoint();

  State state_ = State::IDLE;
  bool usable_ = false;
  bool begun_ = false;
  const char* reason_ = "";
  uint64_t* words_;
  size_t word_count_;
  uint64_t last_us_ = 0;
  double time_ = 0;       // on the plan, s
  double rate_ = 1;       // seconds of the plan in a second
  double stop_time_ = 1;  // s from full speed to rest
  Vector3f start_, target_, shift_;
  tern_grid grid_{};  // zeros: fly_to() may come before set_map()
  tern_planner planner_;
  tern_request request_;
  tern_report report_{};
  tern_trajectory plan_;
};
