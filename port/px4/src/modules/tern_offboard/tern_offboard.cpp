// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tern_offboard start EAST NORTH UP: plans from where the vehicle hovers to a point of the local frame, past the boxes
// of kObstacles, and streams the plan as offboard setpoints at 50 Hz. The flight begins when the pilot switches to
// offboard, and ends in a hover. tern_offboard stop: ends the stream; PX4 then does what COM_OBL_RC_ACT says.
#include <drivers/drv_hrt.h>
#include <math.h>
#include <parameters/param.h>
#include <px4_platform_common/log.h>
#include <px4_platform_common/px4_config.h>
#include <px4_platform_common/tasks.h>
#include <px4_platform_common/time.h>
#include <stdlib.h>
#include <string.h>
#include <uORB/topics/offboard_control_mode.h>
#include <uORB/topics/trajectory_setpoint.h>
#include <uORB/topics/vehicle_local_position.h>
#include <uORB/topics/vehicle_status.h>

#include <tern/export.hpp>
#include <tern/tern.hpp>
#include <uORB/Publication.hpp>
#include <uORB/Subscription.hpp>

namespace {

constexpr int kStackBytes = 12288;   // Tern takes at most 7,680 of them; the rest is PX4's calls
constexpr unsigned kPeriod = 20000;  // us: 50 Hz
constexpr tern::Box kObstacles[] = {{{4.0, -3.0, 0.0}, {5.0, 3.0, 5.0}}};  // yours: from a map, or none
constexpr tern::GridSpec kSpec = {
    {-5.0, -10.0, -1.0}, 0.2, {100, 100, 35}, {{-5.0, -10.0, 0.5}, {15.0, 10.0, 6.0}}, 0.3, 0.3};
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

volatile bool should_exit = false;
volatile bool running = false;

double parameter(const char* name, double otherwise) {
  float value = 0.f;
  return param_get(param_find(name), &value) == 0 ? static_cast<double>(value) : otherwise;
}

tern::Limits limits() {
  tern::Px4Limits own = tern::px4_limits();
  own.mpc_xy_vel_max = parameter("MPC_XY_VEL_MAX", own.mpc_xy_vel_max);
  own.mpc_z_vel_max_up = parameter("MPC_Z_VEL_MAX_UP", own.mpc_z_vel_max_up);
  own.mpc_z_vel_max_dn = parameter("MPC_Z_VEL_MAX_DN", own.mpc_z_vel_max_dn);
  own.mpc_acc_hor = parameter("MPC_ACC_HOR", own.mpc_acc_hor);
  own.mpc_acc_up_max = parameter("MPC_ACC_UP_MAX", own.mpc_acc_up_max);
  own.mpc_acc_down_max = parameter("MPC_ACC_DOWN_MAX", own.mpc_acc_down_max);
  own.mpc_jerk_auto = parameter("MPC_JERK_AUTO", own.mpc_jerk_auto);
  return tern::limits_from_px4(own);
}

/// Plans from the hover at `local` to the goal, and the yaw along the motion.
bool make_plan(const vehicle_local_position_s& local) {
  if (grid.bind(kSpec, grid_words, kGridWords) != tern::Status::kOk) return false;
  for (const tern::Box& box : kObstacles) grid.mark_box(box);
  grid.inflate();
  static tern::Planner planner(&workspace, sizeof workspace);
  request.start = tern::State{};
  request.start.position =
      tern::ned_from_enu({static_cast<double>(local.x), static_cast<double>(local.y), static_cast<double>(local.z)});
  request.goal.position = goal;
  request.limits = limits();
  if (planner.plan(grid, request, plan, report) != tern::Status::kOk) {
    PX4_ERR("no plan: %s, field %s", tern::status_name(report.status), tern::field_name(report.field));
    return false;
  }
  // PX4's heading is clockwise from north, Tern's counter-clockwise from east.
  const double heading = static_cast<double>(local.heading);
  const tern::YawRequest yaw = tern::yaw_request({sin(heading), cos(heading)}, 1.0, 1.0);
  return yaw_planner.plan(plan, yaw, yaw_plan) == tern::Status::kOk;
}

/// Publishes what to fly `t` seconds after the plan's beginning.
void publish(double t, uORB::Publication<offboard_control_mode_s>& modes,
             uORB::Publication<trajectory_setpoint_s>& setpoints) {
  offboard_control_mode_s mode{};
  mode.timestamp = hrt_absolute_time();
  mode.position = true;
  modes.publish(mode);

  const tern::SetpointNed from =
      tern::setpoint_ned(tern::evaluate(plan, t), tern::evaluate(yaw_plan, t), tern::Vec3{0.0, 0.0, 0.0});
  trajectory_setpoint_s setpoint{};
  setpoint.timestamp = mode.timestamp;
  memcpy(setpoint.position, from.position, sizeof from.position);
  memcpy(setpoint.velocity, from.velocity, sizeof from.velocity);
  memcpy(setpoint.acceleration, from.acceleration, sizeof from.acceleration);
  memcpy(setpoint.jerk, from.jerk, sizeof from.jerk);
  setpoint.yaw = from.yaw;
  setpoint.yawspeed = from.yaw_rate;
  setpoints.publish(setpoint);
}

/// Streams the hover until the pilot switches to offboard, then the plan, then the hover at its end.
void stream() {
  uORB::Publication<offboard_control_mode_s> modes{ORB_ID(offboard_control_mode)};
  uORB::Publication<trajectory_setpoint_s> setpoints{ORB_ID(trajectory_setpoint)};
  uORB::Subscription statuses{ORB_ID(vehicle_status)};
  hrt_abstime begin = 0;
  while (!should_exit) {
    vehicle_status_s status{};
    const bool offboard = statuses.copy(&status) && status.nav_state == vehicle_status_s::NAVIGATION_STATE_OFFBOARD;
    if (offboard && begin == 0) begin = hrt_absolute_time();
    if (!offboard && begin != 0) return;  // the pilot took over: this plan is over
    publish(begin == 0 ? 0.0 : static_cast<double>(hrt_absolute_time() - begin) * 1e-6, modes, setpoints);
    px4_usleep(kPeriod);
  }
}

int run(int, char*[]) {
  uint32_t faults = 0;
  vehicle_local_position_s local{};
  uORB::Subscription positions{ORB_ID(vehicle_local_position)};
  if (tern::self_test(tern::kConfigurationHash, &faults) != tern::Status::kOk) {
    PX4_ERR("self-test failed, faults 0x%x", static_cast<unsigned>(faults));
  } else if (!positions.copy(&local) || !local.xy_valid || !local.z_valid) {
    PX4_ERR("no local position");
  } else if (make_plan(local)) {
    PX4_INFO("plan of %d ms; switch to offboard", static_cast<int>(1000.0 * tern::duration(plan)));
    stream();
  }
  running = false;
  return 0;
}

int start(int argc, char* argv[]) {
  if (running || argc != 5) return 1;
  goal = {strtod(argv[2], nullptr), strtod(argv[3], nullptr), strtod(argv[4], nullptr)};
  should_exit = false;
  running = true;
  // Below everything that flies: a plan may take long.
  const int task =
      px4_task_spawn_cmd("tern_offboard", SCHED_DEFAULT, SCHED_PRIORITY_DEFAULT - 20, kStackBytes, run, nullptr);
  if (task < 0) running = false;
  return task < 0 ? 1 : 0;
}

}  // namespace

extern "C" __EXPORT int tern_offboard_main(int argc, char* argv[]) {
  if (argc > 1 && strcmp(argv[1], "start") == 0) return start(argc, argv);
  if (argc > 1 && strcmp(argv[1], "stop") == 0) {
    should_exit = true;
    return 0;
  }
  PX4_INFO("tern_offboard start EAST NORTH UP (m, local frame) | stop; %s", running ? "running" : "not running");
  return 1;
}
