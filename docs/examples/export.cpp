// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/export.md: a plan as setpoints of an autopilot, within the autopilot's limits.
#include "tern/tern.hpp"
#include "tern_stacks/stacks.hpp"

static int32_t sent = 0;
static uint8_t last[tern::kMavlinkSetpointBytes];

/// Stands for the link to the autopilot.
static void write_bytes(const uint8_t* bytes, int32_t count) {
  for (int32_t i = 0; i < count; ++i) last[i] = bytes[i];
  sent += count;
}

/// Sends the setpoint of time t after the plan's beginning. Call it at 50 Hz or more.
static void send_setpoint(const tern::Trajectory& plan, const tern::YawPlan& yaw_plan, double t) {
  const tern::Vec3 local_origin{0.0, 0.0, 0.0};  // the autopilot's, in Tern's world
  const tern::SetpointNed setpoint =
      tern::setpoint_ned(tern::evaluate(plan, t), tern::evaluate(yaw_plan, t), local_origin);
  static uint8_t sequence = 0;
  const tern::MavlinkHeader header{255, 190, 1, 1, sequence++, static_cast<uint32_t>(1000.0 * t)};
  uint8_t frame[tern::kMavlinkSetpointBytes];
  write_bytes(frame, tern::mavlink_setpoint(setpoint, header, frame));
}

int main() {
  tern::Request request{};
  tern::Px4Limits parameters = tern::px4_limits();  // the firmware's defaults
  parameters.mpc_xy_vel_max = 5.0;                  // what your vehicle has
  if (tern::limits_from_px4(parameters, request.limits) != tern::Status::kOk) return 1;

  tern::Trajectory hover{};
  hover.count = 1;
  hover.origin = {1.0, 2.0, 3.0};
  hover.segments[0].duration = 1.0;
  send_setpoint(hover, tern::YawPlan{}, 0.5);
  return sent > 12 && last[0] == 0xFD ? 0 : 1;
}
