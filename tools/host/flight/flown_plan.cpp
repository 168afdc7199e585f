// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flown_plan.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/flight/flight_recorder.hpp"
#include "host/nanoseconds.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

constexpr double kSettle = 1.0;  // seconds at the end

using PlanJson = nlohmann::json;

tern::Vec3 vec3(const PlanJson& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

tern::Segment segment_of(const PlanJson& json) {
  tern::Segment segment{};
  segment.duration = json.at("duration").get<double>();
  const PlanJson& points = json.at("control_points");
  if (points.size() != tern::kControlPoints) throw std::runtime_error("a segment has eight control points");
  for (std::size_t i = 0; i < points.size(); ++i) segment.points[i] = vec3(points[i]);
  return segment;
}

tern::Trajectory trajectory_of(const PlanJson& json) {
  tern::Trajectory plan{};
  const PlanJson& segments = json.at("segments");
  if (segments.empty() || segments.size() > tern::kMaxSegments) throw std::runtime_error("too few or many segments");
  for (const PlanJson& segment : segments) plan.segments[plan.count++] = segment_of(segment);
  return plan;
}

}  // namespace

FinishedPlan read_finished_plan(const std::string& path) {
  try {
    const PlanJson plan = PlanJson::parse(read_text(path));
    return {trajectory_of(plan), plan.value("tracking_margin", 0.0)};
  } catch (const PlanJson::exception& error) {
    throw std::runtime_error(path + ": not a plan with a trajectory: " + error.what());
  }
}

FlightResult fly_plan(const tern::Trajectory& plan, const FlightSettings& settings) {
  const double inf = std::numeric_limits<double>::infinity();
  FlightWorld nothing;
  nothing.boundary = {{-inf, -inf, -inf}, {inf, inf, inf}};
  nothing.settings = settings;
  const double time = tern::duration(plan);
  const tern::Vec3 from = tern::evaluate(plan, 0.0).position;
  const tern::Vec3 to = tern::evaluate(plan, time).position;
  const double yaw = std::atan2(to.y - from.y, to.x - from.x);
  const Setpoints setpoints = [&](double t) { return Setpoint{tern::evaluate(plan, t), yaw, 0.0}; };
  const std::unique_ptr<Vehicle> vehicle = make_vehicle(vehicle_settings_of(settings), setpoints(0.0));
  FlightRecorder recorder(nothing);
  const auto last = static_cast<std::int64_t>(std::ceil((time + kSettle) * settings.tick_hz));
  for (std::int64_t k = 0; k <= last; ++k) {
    const double t = static_cast<double>(k) / settings.tick_hz;
    if (k > 0) vehicle->fly_to(t, setpoints);
    recorder.note(nanoseconds(t), {tern::evaluate(plan, t), to}, *vehicle, yaw, {});
  }
  FlightResult result = recorder.finish();
  result.status = result.tracking_max <= settings.tracking_margin ? "kept" : "exceeded";
  return result;
}

}  // namespace tern_host
