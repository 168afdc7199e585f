// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/integration.md: what a controller takes from a plan at time t.
#include "tern/tern.hpp"

static double sent = 0.0;

/// Stands for the link to the motors.
static void send(double thrust, const double (&)[4], const tern::Vec3&) {
  sent = thrust;
}

static void control(const tern::Trajectory& trajectory, double mass, double t) {
  const tern::Sample sample = tern::evaluate(trajectory, t);
  const tern::FlatState flat = tern::flat_state(sample, {1.0, 0.0, 0.0});  // cos, sin of the yaw, and its rate
  send(mass * flat.thrust, flat.quaternion, flat.body_rates);
}

int main() {
  tern::Trajectory hover{};
  hover.count = 1;
  hover.segments[0].duration = 1.0;
  control(hover, 2.0, 0.5);
  return sent > 19.6 && sent < 19.7 ? 0 : 1;
}
