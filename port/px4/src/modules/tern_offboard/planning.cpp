// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning.hpp"

#include <parameters/param.h>
#include <px4_platform_common/log.h>

namespace tern_offboard {
namespace {

constexpr tern::Box kObstacles[] = {{{4.0, -3.0, 0.0}, {5.0, 3.0, 5.0}}};  // yours: from a map, or none
constexpr tern::GridSpec kSpec = {
    {-5.0, -10.0, -1.0}, 0.2, {100, 100, 35}, {{-5.0, -10.0, 0.5}, {15.0, 10.0, 6.0}}, 0.3, 0.7};
constexpr double kSpeed = 1.0;        // m/s, horizontal, of plans; well below MPC_XY_VEL_MAX
constexpr size_t kGridWords = 32768;  // tern::grid_words(kSpec.dims), rounded up

static_assert(kSpec.dims.x * kSpec.dims.y * kSpec.dims.z <= tern::kMaxCells, "kSpec is too large for this profile");

// Too large for a task's stack. A board with external RAM places them there with its linker script.
tern::Workspace workspace;
uint64_t grid_words[kGridWords];
tern::Grid grid;
tern::Request request;
tern::Report report;
tern::Trajectory plan;
tern::YawPlanner yaw_planner;
tern::YawPlan yaw_plan;
tern::Vec3 goal;

tern::Planner& planner() {
  static tern::Planner only(&workspace, sizeof workspace);
  return only;
}

double parameter(const char* name, double otherwise) {
  float value = 0.f;
  return param_get(param_find(name), &value) == 0 ? static_cast<double>(value) : otherwise;
}

bool read_limits(tern::Limits& limits) {
  tern::Px4Limits own = tern::px4_limits();
  own.mpc_xy_vel_max = parameter("MPC_XY_VEL_MAX", own.mpc_xy_vel_max);
  own.mpc_z_vel_max_up = parameter("MPC_Z_VEL_MAX_UP", own.mpc_z_vel_max_up);
  own.mpc_z_vel_max_dn = parameter("MPC_Z_VEL_MAX_DN", own.mpc_z_vel_max_dn);
  own.mpc_acc_hor = parameter("MPC_ACC_HOR", own.mpc_acc_hor);
  own.mpc_acc_up_max = parameter("MPC_ACC_UP_MAX", own.mpc_acc_up_max);
  own.mpc_acc_down_max = parameter("MPC_ACC_DOWN_MAX", own.mpc_acc_down_max);
  own.mpc_jerk_auto = parameter("MPC_JERK_AUTO", own.mpc_jerk_auto);
  tern::Field field = tern::Field::kNone;
  const tern::Status status = tern::limits_from_px4(own, limits, &field);
  if (limits.v_horizontal > kSpeed) limits.v_horizontal = kSpeed;
  if (status == tern::Status::kOk) return true;
  PX4_ERR("PX4's parameters give no limits: %s, %s", tern::status_name(status), tern::field_name(field));
  return false;
}

bool make_map() {
  const tern::Status status = grid.bind(kSpec, grid_words, kGridWords);
  if (status != tern::Status::kOk) {
    PX4_ERR("no map: %s", tern::status_name(status));
    return false;
  }
  for (const tern::Box& box : kObstacles) grid.mark_box(box);
  grid.inflate();
  return true;
}

}  // namespace

tern::Status begin_plan(const Hover& from) {
  request.start = tern::State{};
  request.start.position = from.position;
  request.goal.position = goal;
  return planner().begin(grid, request);
}

tern::Status advance_plan(uint32_t work) {
  return planner().step(work);
}

bool finish_plan(const Hover& from) {
  if (planner().finish(plan, report) != tern::Status::kOk) {
    PX4_ERR("no plan: %s, field %s", tern::status_name(report.status), tern::field_name(report.field));
    return false;
  }
  const tern::Yaw nose = yaw_at(from.heading).yaw;
  const tern::YawRequest yaw = tern::yaw_request({nose.cosine, nose.sine}, 1.0, 1.0);
  return yaw_planner.plan(plan, yaw, yaw_plan) == tern::Status::kOk;
}

bool make_plan(const Hover& from, const tern::Vec3& to) {
  goal = to;
  if (!make_map() || !read_limits(request.limits)) return false;
  tern::Status status = begin_plan(from);
  while (status == tern::Status::kRunning) status = planner().step(1000);
  return finish_plan(from);
}

const tern::Trajectory& the_plan() {
  return plan;
}

const tern::YawPlan& the_yaw_plan() {
  return yaw_plan;
}

}  // namespace tern_offboard
