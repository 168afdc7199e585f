// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "margins/flown.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "host/flight/stack_margin.hpp"
#include "tern_stacks/stacks.hpp"

namespace tern_bench {

tern::Limits equal_limits(double v, double jerk) {
  tern::Limits limits{{v, v, std::min(v, 3.0)}, {v, v, v}};
  limits.v_min = {-v, -v, -std::min(v, 1.5)};
  limits.v_horizontal = v;
  limits.a_horizontal = v;
  limits.j_max = {jerk, jerk, jerk};
  return limits;
}

tern::Limits preset_limits(const std::string& stack, double v) {
  tern::Limits limits{{v, v, v}, {v, v, v}};
  tern::Px4Limits px4 = tern::px4_limits();
  px4.mpc_xy_vel_max = v / tern::kPx4SpeedShare;
  tern::ArdupilotLimits ardupilot = tern::ardupilot_limits();
  ardupilot.wpnav_speed_m_s = v;
  const tern::Status status =
      stack == "px4" ? tern::limits_from_px4(px4, limits) : tern::limits_from_ardupilot(ardupilot, limits);
  if (status != tern::Status::kOk) throw std::runtime_error("the stack's limits are refused");
  return limits;
}

tern_host::FlightSettings stack_settings(const std::string& stack, double speed, double drag, double wind) {
  tern_host::FlightSettings settings;
  settings.tracking = stack;
  settings.stack_speed = speed;
  settings.air.drag = drag;
  settings.air.wind = wind;
  settings.tick_hz = 50.0;
  return settings;
}

std::vector<tern::Trajectory> Plans::of(const tern::Limits& limits) {
  std::vector<tern::Trajectory> plans;
  for (int map = 1; map <= 5; ++map) {
    tern_host::Scenario scenario = tern_host::read_scenario(TERN_MAPS_DIR "/map" + std::to_string(map) + ".txt");
    scenario.limits = limits;
    for (int way = 0; way < 2; ++way) {
      const tern_host::PlanResult result = session_.plan(scenario);
      if (!result.ok()) throw std::runtime_error(scenario.name + ": no plan");
      plans.push_back(result.trajectory);
      std::swap(scenario.start, scenario.goal);
    }
  }
  return plans;
}

double largest_error(const std::vector<tern::Trajectory>& plans, const tern_host::FlightSettings& settings, int seeds) {
  double largest = 0.0;
  for (const tern::Trajectory& plan : plans) {
    largest = std::max(largest, tern_host::measure_margin(plan, settings, seeds).controller);
  }
  return largest;
}

}  // namespace tern_bench
