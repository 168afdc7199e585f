// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/page/replayed_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "host/flight/flight_replay.hpp"
#include "host/page/flight_film.hpp"

namespace tern_host {
namespace {

constexpr double kHeights = 1.2;  // m above and below what was flown: floor and ceiling would hide all between them

/// What a page must know of a flight before it is filmed.
class Surroundings {
 public:
  void note(const ReplayedTick& tick) {
    const tern::Vec3 p = tick.command.sample.position;
    if (ticks_++ == 0) begin(tick);
    grow(world_.boundary, p, world_.settings.sensor_range);
    result_.length += std::hypot(p.x - before_.x, p.y - before_.y, p.z - before_.z);
    before_ = p;
    world_.goal = tick.goal;
    result_.time = static_cast<double>(ticks_ - 1) / world_.settings.tick_hz;
    result_.work_max = std::max(result_.work_max, tick.report.work);
    stray_ = std::max(stray_, tick.report.stray);
    last_ = tick.report;
  }
  FlightWorld world(const std::string& name) {
    world_.name = name;
    world_.settings.time_limit = result_.time;
    return world_;
  }
  FlightResult result() {
    result_.status = last_.reason == tern::FlightReason::kArrived ? "reached" : tern::flight_mode_name(last_.mode);
    result_.reason = tern::flight_reason_text(last_.reason);
    result_.blocked_by = last_.blocked_by;
    result_.blocked_at = last_.blocked_at;
    result_.blocked_fence = last_.blocked_fence;
    constexpr double kNobodyMeasured = std::numeric_limits<double>::infinity();
    result_.min_clearance = kNobodyMeasured;
    result_.tracking_max = stray_ > 0.0 ? stray_ : kNobodyMeasured;
    result_.asked = last_.asked;
    result_.committed = last_.committed;
    result_.dropped = last_.dropped;
    result_.failed = last_.failed;
    return result_;
  }

 private:
  void begin(const ReplayedTick& tick) {
    FlightSettings& s = world_.settings;
    const tern::MapSpec& map = tick.map_spec;
    s.body_radius = map.radius;
    s.tracking_margin = map.tracking_margin;
    s.cell = map.cell;
    s.depth_margin = 0.0;
    s.sensor_range = map.range;
    s.v_max = tick.spec.limits.v_max.x;
    s.a_max = tick.spec.limits.a_max.x;
    s.j_max = tick.spec.limits.j_max.x;
    s.work_per_tick = static_cast<int>(tick.spec.work_per_tick);
    s.tick_hz = 1e9 / static_cast<double>(tick.spec.tick);
    world_.start = before_ = tick.command.sample.position;
    world_.boundary = {world_.start, world_.start};
  }
  static void grow(tern::Box& box, const tern::Vec3& p, double range) {
    box.lower.x = std::min(box.lower.x, p.x - range);
    box.lower.y = std::min(box.lower.y, p.y - range);
    box.lower.z = std::min(box.lower.z, p.z - kHeights);
    box.upper.x = std::max(box.upper.x, p.x + range);
    box.upper.y = std::max(box.upper.y, p.y + range);
    box.upper.z = std::max(box.upper.z, p.z + kHeights);
  }

  FlightWorld world_;
  FlightResult result_;
  tern::FlightReport last_{};
  tern::Vec3 before_{};
  double stray_ = 0.0;
  std::uint64_t ticks_ = 0;
};

Setpoint setpoint_of(const ReplayedTick& tick) {
  const tern::YawSample yaw = tick.flight.yaw(tick.t);
  return {tick.command.sample, yaw.angle, yaw.yaw.rate};
}

}  // namespace

std::string replayed_run(const std::string& name, const std::string& bytes) {
  Surroundings surroundings;
  replay_flight(bytes, [&](const ReplayedTick& tick) { surroundings.note(tick); });
  const FlightWorld world = surroundings.world(name);
  FlightFilm film(world);
  VehicleSettings exact;
  exact.kind = "perfect";
  replay_flight(bytes, [&](const ReplayedTick& tick) {
    const Setpoint setpoint = setpoint_of(tick);
    film.note({tick.t, tick.report, tick.command, *make_vehicle(exact, setpoint), setpoint.yaw,
               std::numeric_limits<double>::infinity(), tick.map, tick.flight, tick.planner, tick.state});
  });
  return film.run(surroundings.result());
}

}  // namespace tern_host
