// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/yaw.md: the nose along the motion, within limits.
#include "tern/tern.hpp"

static tern::Yaw sent{};

/// Stands for the controller.
static void fly(const tern::FlatState&, const tern::Yaw& yaw) {
  sent = yaw;
}

static void control(const tern::Trajectory& trajectory, const tern::YawPlan& yaw_plan, double t) {
  const tern::Yaw yaw = tern::evaluate(yaw_plan, t).yaw;
  fly(tern::flat_state(tern::evaluate(trajectory, t), yaw), yaw);
}

static bool plan_yaw(const tern::Trajectory& trajectory, const tern::YawSample& now, tern::YawPlan& yaw_plan) {
  static tern::YawPlanner planner;  // 23 kB with the default capacities
  tern::YawRequest request = tern::yaw_request({now.yaw.cosine, now.yaw.sine}, 1.0, 2.0);  // rad/s, rad/s^2
  request.start_rate = now.yaw.rate;
  request.start_acceleration = now.acceleration;
  return planner.plan(trajectory, request, yaw_plan) == tern::Status::kOk;
}

int main() {
  tern::Trajectory north{};  // 8 m along y in 4 s
  north.count = 1;
  north.segments[0].duration = 4.0;
  for (int i = 0; i <= tern::kDegree; ++i) north.segments[0].points[i] = {0.0, 8.0 * i / tern::kDegree, 0.0};
  tern::YawPlan yaw_plan{};
  if (!plan_yaw(north, {{1.0, 0.0, 0.0}, 0.0, 0.0}, yaw_plan)) return 1;
  control(north, yaw_plan, 4.0);
  return sent.sine > 0.999 ? 0 : 1;
}
