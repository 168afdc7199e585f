// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AP_Tern.h"

#include <AP_HAL/AP_HAL.h>
#include <AP_Vehicle/AP_Vehicle.h>
#include <string.h>

// Units of work in one update. Measure the longest on your board: an update must fit into its place of the scheduler.
static const uint32_t WORK_PER_UPDATE = 100;
static const uint64_t LONGEST_US = 200000;  // from one setpoint to the next
static const float START_TOLERANCE = 0.1f;  // m from the plan's start to the vehicle, when the flight begins
static const float REST_SPEED = 0.3f;       // m/s
static const float STRAY = 1.0f;            // m from the last setpoint; farther away, the plan is given up
static const double STOP_DECELERATION = 2;  // m/s^2

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

bool AP_Tern::fly_to(const Vector3f& goal_ned) {
  tern_request_init(&request_);
  request_.goal.position = {goal_ned.y, goal_ned.x, -goal_ned.z};
  if (!usable_ || state_ == State::FLYING || (state_ == State::STOPPING && rate_ > 0)) {
    return false;
  }
  if (tern_limits_from_ardupilot(&parameters, &request_.limits, nullptr) != 0) {
    reason_ = "a parameter is out of range; they are in metres";
    return false;
  }
  state_ = State::PLANNING;
  reason_ = "";
  begun_ = false;
  return true;
}

void AP_Tern::update(const Vehicle& now) {
  const uint64_t time_us = AP_HAL::micros64();
  const uint64_t step_us = time_us - last_us_;
  last_us_ = time_us;
  if (state_ == State::IDLE || state_ == State::FAILED) {
    return;
  }
  if (!now.ready) {
    state_ = State::FAILED;
    reason_ = "not in guided mode, not armed, on the ground, or without an estimate";
  } else if (state_ == State::PLANNING) {
    plan(now);
  } else {
    fly(now, step_us);
  }
}

void AP_Tern::stop() {
  if (state_ == State::FLYING) {
    slow_down("stop");
  } else if (state_ == State::PLANNING) {
    state_ = State::IDLE;
  }
}

// Until the flight begins, nothing is sent: in guided mode, ArduPilot hovers.
void AP_Tern::plan(const Vehicle& now) {
  const bool at_rest = now.velocity.length() <= REST_SPEED;
  if (!begun_) {
    if (!at_rest) {
      return;
    }
    start_ = now.position;
    request_.start.position = {start_.y, start_.x, -start_.z};
    tern_plan_begin(&planner_, &grid_, &request_);
    begun_ = true;
  }
  if (strcmp(tern_status_name(tern_plan_step(&planner_, WORK_PER_UPDATE)), "running") == 0) {
    return;
  }
  begun_ = false;
  if (tern_plan_finish(&planner_, &plan_, &report_) != 0) {
    state_ = State::FAILED;
    reason_ = "no plan";
    return;
  }
  if (!at_rest || (now.position - start_).length() > START_TOLERANCE) {
    return;  // plans again, from where the vehicle has come to
  }
  state_ = State::FLYING;
  time_ = 0;
  rate_ = 1;
  shift_ = Vector3f();
  target_ = start_;
  send_setpoint();
}

void AP_Tern::fly(const Vehicle& now, uint64_t step_us) {
  const bool late = step_us > LONGEST_US;
  const bool strays = (now.position - target_).length() > STRAY;
  if (late || strays) {
    // On from where the vehicle is: it flew on with the last velocity, or its estimate was reset.
    shift_ = shift_ + (now.position - target_);
    slow_down(late ? "no update for 0.2 s" : "1 m from the setpoint");
  }
  advance(late ? 0 : step_us);
  send_setpoint();
}

void AP_Tern::slow_down(const char* reason) {
  if (state_ == State::STOPPING) {
    return;
  }
  tern_sample at;
  tern_evaluate(&plan_, time_, &at);
  const tern_vec3& v = at.velocity;
  stop_time_ = Vector3f(v.x, v.y, v.z).length() / STOP_DECELERATION;
  reason_ = reason;
  state_ = State::STOPPING;
  if (stop_time_ * 10 < 1) {
    rate_ = 0;
  }
}

void AP_Tern::advance(uint64_t step_us) {
  // In whole numbers: constants have single precision here.
  const double dt = static_cast<double>(step_us) / 1000000;
  double rate = rate_;
  if (state_ == State::STOPPING && rate_ > 0) {
    rate -= dt / stop_time_;
    rate = rate > 0 ? rate : 0;
  }
  time_ += (rate_ + rate) / 2 * dt;
  rate_ = rate;
}

void AP_Tern::send_setpoint() {
  tern_sample sample;
  tern_setpoint setpoint;
  tern_evaluate(&plan_, time_, &sample);
  tern_setpoint_ned(&sample, nullptr, nullptr, &setpoint);
  const float rate = static_cast<float>(rate_);
  const float brake = state_ == State::STOPPING && rate_ > 0 ? static_cast<float>(1 / stop_time_) : 0.0f;
  const float* v = setpoint.velocity;
  const float* a = setpoint.acceleration;
  const Vector3f velocity(rate * v[0], rate * v[1], rate * v[2]);
  const Vector3f acceleration(rate * rate * a[0] - brake * v[0], rate * rate * a[1] - brake * v[1],
                              rate * rate * a[2] - brake * v[2]);
  target_ = Vector3f(setpoint.position[0], setpoint.position[1], setpoint.position[2]) + shift_;
  // The yaw is left to ArduPilot.
  if (!AP::vehicle()->set_target_posvelaccel_NED(target_, velocity, acceleration, false, 0, false, 0, false)) {
    state_ = State::FAILED;
    reason_ = "ArduPilot refused the setpoint";
  } else if (state_ == State::FLYING && time_ > tern_duration(&plan_)) {
    state_ = State::ARRIVED;
  }
}
