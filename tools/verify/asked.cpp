// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/asked.hpp"

#include <algorithm>
#include <tuple>

namespace tern_verify {
namespace {

Motion motion_of(const Json& state) {
  return {point_of(state.at("position")), point_of(state.at("velocity")), point_of(state.at("acceleration")),
          point_of(state.at("jerk"))};
}

Rational number_or_zero(const Json& json, const char* key) {
  return json.contains(key) ? number_of(json.at(key)) : Rational(0);
}

std::vector<Bound> bounds_of(const Json& limits) {
  const Point none{0, 0, 0};
  const Point jerk = limits.contains("j_max") ? point_of(limits.at("j_max")) : none;
  std::vector<Bound> bounds;
  add_bounds(1, point_of(limits.at("v_max")), point_of(limits.at("v_min")), number_or_zero(limits, "v_horizontal"),
             bounds);
  add_bounds(2, point_of(limits.at("a_max")), point_of(limits.at("a_min")), number_or_zero(limits, "a_horizontal"),
             bounds);
  add_bounds(3, jerk, none, number_or_zero(limits, "j_horizontal"), bounds);
  add_bounds({number_or_zero(limits, "thrust_max"), number_or_zero(limits, "thrust_min"),
              number_or_zero(limits, "tilt_tangent"), number_or_zero(limits, "rate_max")},
             bounds);
  return bounds;
}

Via via_of(const Json& json) {
  Via via{point_of(json.at("position")),
          number_of(json.at("tolerance")),
          json.at("stop").get<bool>(),
          {},
          number_or_zero(json, "dwell")};
  if (json.contains("velocity")) via.velocity = point_of(json.at("velocity"));
  return via;
}

bool same(const Bound& a, const Bound& b) {
  return std::tie(a.derivative, a.axis, a.sign, a.most) == std::tie(b.derivative, b.axis, b.sign, b.most);
}

bool same(const Via& a, const Via& b) {
  return std::tie(a.position, a.tolerance, a.stop, a.velocity, a.dwell) ==
         std::tie(b.position, b.tolerance, b.stop, b.velocity, b.dwell);
}

template <typename T>
bool all_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
}

}  // namespace

Problem asked_of(const Json& plan) {
  Problem asked;
  asked.cell = number_of(plan.at("resolution"));
  asked.radius = number_of(plan.at("robot_radius"));
  asked.tracking_margin = number_of(plan.at("tracking_margin"));
  asked.bounds = bounds_of(plan.at("limits"));
  asked.start = motion_of(plan.at("start_state"));
  asked.goal = motion_of(plan.at("goal_state"));
  if (plan.contains("frame")) {
    const Json& frame = plan.at("frame");
    for (const char* const key : {"latitude", "longitude", "height"}) {
      if (frame.contains(key)) asked.frame.push_back(number_of(frame.at(key)));
    }
    asked.epoch = frame.value("epoch", "");
  }
  if (!plan.contains("vias")) return asked;
  for (const Json& via : plan.at("vias")) asked.vias.push_back(via_of(via));
  return asked;
}

std::string difference(const Problem& a, const Problem& b) {
  if (a.cell != b.cell) return "resolution";
  if (a.radius != b.radius) return "robot_radius";
  if (a.tracking_margin != b.tracking_margin) return "tracking_margin";
  if (a.frame != b.frame || a.epoch != b.epoch) return "frame";
  if (!all_same(a.bounds, b.bounds)) return "limits";
  if (a.start != b.start) return "start_state";
  if (a.goal != b.goal) return "goal_state";
  return all_same(a.vias, b.vias) ? "" : "vias";
}

}  // namespace tern_verify
