// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AP_Tern.h"

#include <AP_HAL/AP_HAL.h>
#include <AP_Vehicle/AP_Vehicle.h>
#include <string.h>

// Units of work in one update. Measure the longest on your board: an update must fit into its place of the scheduler.
static const uint32_t WORK_PER_UPDATE = 100;

AP_Tern::AP_Tern(void* workspace, size_t bytes, uint64_t* words, size_t word_count)
    : words_(words), word_count_(word_count) {
  tern_ardupilot_defaults(&parameters);
  usable_ = tern_abi() == TERN_ABI && tern_self_test(tern_header_hash(), nullptr) == 0 &&
            tern_planner_init(&planner_, workspace, bytes) == 0;
}

bool AP_Tern::set_map(const tern_grid_spec& spec, const tern_box* boxes, uint8_t count) {
  if (tern_grid_bind(&grid_, &spec, words_, word_count_) != 0) {
    return false;
  }
  for (uint8_t i = 0; i < count; i++) {
    tern_grid_mark_box(&grid_, &boxes[i]);
  }
  return tern_grid_inflate(&grid_) == 0;
}

bool AP_Tern::fly_to(const Vector3f& here_ned, const Vector3f& goal_ned) {
  if (!usable_) {
    return false;
  }
  tern_request_init(&request_);
  request_.start.position = {here_ned.y, here_ned.x, -here_ned.z};
  request_.goal.position = {goal_ned.y, goal_ned.x, -goal_ned.z};
  if (tern_limits_from_ardupilot(&parameters, &request_.limits, nullptr) != 0) {
    return false;
  }
  tern_plan_begin(&planner_, &grid_, &request_);
  state_ = State::PLANNING;
  return true;
}

void AP_Tern::update() {
  if (state_ == State::PLANNING) {
    plan_slice();
  } else if (state_ == State::FLYING || state_ == State::ARRIVED) {
    send_setpoint();
  }
}

void AP_Tern::plan_slice() {
  const uint8_t answer = tern_plan_step(&planner_, WORK_PER_UPDATE);
  if (strcmp(tern_status_name(answer), "running") == 0) {
    return;
  }
  const bool found = tern_plan_finish(&planner_, &plan_, &report_) == 0;
  state_ = found ? State::FLYING : State::FAILED;
  begin_us_ = AP_HAL::micros64();
}

void AP_Tern::send_setpoint() {
  // In whole numbers: constants have single precision here.
  const double t = static_cast<double>(AP_HAL::micros64() - begin_us_) / 1000000;
  tern_sample sample;
  tern_setpoint setpoint;
  tern_evaluate(&plan_, t, &sample);
  tern_setpoint_ned(&sample, nullptr, nullptr, &setpoint);
  const Vector3f position(setpoint.position[0], setpoint.position[1], setpoint.position[2]);
  const Vector3f velocity(setpoint.velocity[0], setpoint.velocity[1], setpoint.velocity[2]);
  const Vector3f acceleration(setpoint.acceleration[0], setpoint.acceleration[1], setpoint.acceleration[2]);
  // The yaw is left to ArduPilot.
  if (!AP::vehicle()->set_target_posvelaccel_NED(position, velocity, acceleration, false, 0, false, 0, false)) {
    state_ = State::FAILED;  // not in guided mode any more
  } else if (t > tern_duration(&plan_)) {
    state_ = State::ARRIVED;
  }
}
