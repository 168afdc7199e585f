// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/plan.hpp"

#include <cmath>

#include "verify/asked.hpp"
#include "verify/json.hpp"

namespace tern_verify {
namespace {

/// No double is nearer to the exact number.
bool is_rounded(double rounded, const Rational& exact) {
  const Rational error = abs(Rational(rounded) - exact);
  for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
    const double next = std::nextafter(rounded, towards);
    if (std::isfinite(next) && abs(Rational(next) - exact) < error) return false;
  }
  return true;
}

/// `control_points` are the points of `relative_points` in the world frame, rounded.
void check_world_points(const Json& json, const Point& origin, const Segment& segment) {
  const Json& points = json.at("control_points");
  bool same = points.size() == segment.points.size();
  for (std::size_t i = 0; same && i < points.size(); ++i) {
    if (points[i].size() != 3) throw InputError("a point has three coordinates");
    for (std::size_t a = 0; a < 3; ++a) {
      same = same && is_rounded(points[i][a].get<double>(), segment.points[i][a] + origin[a]);
    }
  }
  if (!same) throw InputError("'control_points' of a segment are not its 'origin' plus its 'relative_points'");
}

Segment segment_in(const Json& json, const Point& origin) {
  Segment segment = segment_of(json);
  check_world_points(json, origin, segment);
  return segment;
}

Plan plan_of(const Json& json) {
  if (json.value("format", "") != "tern-plan/1") throw InputError("its 'format' is not 'tern-plan/1'");
  if (json.value("status", "") != "ok") throw InputError("it has no trajectory: its 'status' is not 'ok'");
  Plan plan;
  plan.origin = point_of(json.at("origin"));
  for (const Json& segment : json.at("segments")) plan.segments.push_back(segment_in(segment, plan.origin));
  if (plan.segments.empty()) throw InputError("it has no segments");
  if (json.contains("goal_missed")) plan.reachable = point_of(json.at("reachable"));
  if (json.contains("start_time")) {
    const Json& begin = json.at("start_time");
    plan.begin = Begin{whole_nanoseconds(number_of(begin)), begin.dump()};
  }
  plan.asked = asked_of(json);
  return plan;
}

}  // namespace

Plan parse_plan(const std::string& text, const std::string& name) {
  Plan plan = read_json(text, name, "plan file", plan_of);
  plan.name = name;
  return plan;
}

void require_same_request(const Problem& scenario, const Plan& plan) {
  const std::string what = plan.asked ? difference(scenario, *plan.asked) : "";
  if (!what.empty()) throw InputError(plan.name + ": it differs from " + scenario.name + " in '" + what + "'");
  if (!plan.begin || plan.begin->seconds == scenario.start_time) return;
  throw InputError(plan.name + ": the plan begins at " + plan.begin->text + " s, " + scenario.name + " at " +
                   text_below(scenario.start_time) + " s: if it should, put 'start_time " + plan.begin->text +
                   "' into the scenario");
}

}  // namespace tern_verify
