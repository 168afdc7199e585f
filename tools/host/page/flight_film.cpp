// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/page/flight_film.hpp"

#include <algorithm>
#include <cmath>

#include "flight/flight_state.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"
#include "host/track_sample.hpp"
#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

constexpr double kPlanStep = 0.1;     ///< seconds between points of a plan
constexpr int kMostPoints = 1000;     ///< of a plan
constexpr double kMostRows = 6000.0;  ///< of the motion
constexpr double kTubeStep = 0.1;     ///< seconds between rows of a tube, at least
constexpr double kMostTubeRows = 1200.0;

/// Seconds of the flight's own time, which begins at 0.
double now(const FlightMoment& moment) {
  return seconds_of(moment.state.facts.time);
}

/// Points of a trajectory from `from` seconds on to its end.
RunJson points_of(const tern::Trajectory& plan, double from) {
  RunJson points = RunJson::array();
  const double end = tern::duration(plan);
  for (int i = 0; i < kMostPoints; ++i) {
    const double t = std::min(from + i * kPlanStep, end);
    append_point(points, tern::evaluate(plan, t).position);
    if (t >= end) break;
  }
  return points;
}

/// What is flown from now on, to its end.
RunJson commands_of(const FlightMoment& moment) {
  RunJson points = RunJson::array();
  const tern::Vec3 end = moment.flight.rest_position();
  for (int i = 0; i < kMostPoints; ++i) {
    const tern::Sample s = moment.flight.command(moment.t + nanoseconds(kPlanStep * i)).sample;
    append_point(points, s.position);
    const bool moves = std::hypot(s.velocity.x, std::hypot(s.velocity.y, s.velocity.z)) > 0.0;
    if (!moves && s.position.x == end.x && s.position.y == end.y && s.position.z == end.z) break;
  }
  return points;
}

RunJson corridor_of(const FlightMoment& moment) {
  const tern::Corridor* const corridor = moment.planner.corridor();
  if (corridor == nullptr) return RunJson::array();
  return corridor_json(*corridor, moment.state.cycle.route.grid().spec().origin);
}

/// Without the voxels at the boundary: floor, ceiling and walls would hide all that is between them.
tern::Box inside_of(const FlightWorld& world) {
  const double skin = 2.0 * world.settings.cell + world.settings.depth_margin;
  const auto& [lower, upper] = world.boundary;
  return {{lower.x + skin, lower.y + skin, lower.z + skin}, {upper.x - skin, upper.y - skin, upper.z - skin}};
}

/// Farther from the world, nothing is shown.
constexpr double kNear = 10.0;

RunJson row_of(const FlightWorld& world, const tern::Vec3& place, double error) {
  if (!(distance_to(world.boundary, place) < kNear)) return nullptr;
  RunJson row = RunJson::array();
  append_point(row, place);
  row.push_back(rounded(error, 2));
  return row;
}

RunJson moving_things_json(const FlightWorld& world, const ThingTotals& things) {
  RunJson list = RunJson::array();
  for (std::size_t k = 0; k < things.places.size(); ++k) {
    const Thing& thing = world.things[k];
    RunJson rows = RunJson::array();
    for (const tern::Vec3& at : things.places[k]) rows.push_back(row_of(world, at, 0.0));
    list.push_back(thing_json({thing.name, false, thing.shape, thing.radius, thing.half, things.step, rows}));
  }
  return list;
}

}  // namespace

FlightFilm::FlightFilm(const FlightWorld& world)
    : world_(world),
      growth_(inside_of(world)),
      tube_step_(std::max(kTubeStep, world.settings.time_limit / kMostTubeRows)),
      stride_(std::max<std::int64_t>(
          1, std::llround(std::ceil(world.settings.time_limit * world.settings.tick_hz / kMostRows)))) {}

void FlightFilm::note(const FlightMoment& moment) {
  if (ticks_ % stride_ == 0) note_motion(moment);
  growth_.note(now(moment), moment.map);
  note_tubes(moment);
  if (moment.report.committed != before_.committed) note_commit(moment);
  if (moment.report.dropped != before_.dropped || moment.report.failed != before_.failed) note_lost(moment);
  before_ = moment.report;
  ++ticks_;
}

void FlightFilm::note_motion(const FlightMoment& moment) {
  tern::Sample sample = moment.command.sample;
  sample.position = moment.vehicle.position();
  sample.velocity = moment.vehicle.velocity();
  motion_.add(sample, moment.vehicle.attitude(), moment.clearance);
  motion_.add("yaw", rounded(moment.yaw));
  motion_.add("work", moment.report.work);
  motion_.add("state", static_cast<int>(moment.report.mode));
}

void FlightFilm::note_tubes(const FlightMoment& moment) {
  const double time = now(moment);
  if (static_cast<double>(tube_rows_) * tube_step_ > time) return;
  const tern::TrackTable& tubes = moment.state.facts.plans.at(moment.state.facts.time).tubes;
  for (std::int32_t k = 0; k < tubes.count; ++k) {
    ShownTube& tube = tubes_[tubes.tracks[k].id];
    tube.of = tubes.tracks[k];
    tube.rows.resize(tube_rows_);
    const TrackSample sample = sample_of(tube.of, time);
    tube.rows.push_back(sample.is_there ? row_of(world_, sample.place, sample.error) : RunJson(nullptr));
  }
  ++tube_rows_;
}

RunJson FlightFilm::tubes_json() const {
  RunJson list = RunJson::array();
  for (const auto& [id, tube] : tubes_) {
    std::vector<RunJson> rows = tube.rows;
    rows.resize(tube_rows_);
    list.push_back(
        thing_json({std::to_string(id), false, tube.of.shape, tube.of.radius, tube.of.half, tube_step_, rows}));
  }
  return list;
}

void FlightFilm::note_commit(const FlightMoment& moment) {
  const tern::Commitment& latest = moment.state.facts.plans.latest();
  RunJson commit = {{"t", rounded(now(moment))},
                    {"branch", rounded(seconds_of(latest.begin()) + latest.branch)},
                    {"step", kPlanStep},
                    {"points", commands_of(moment)},
                    {"wished", points_of(latest.planned, latest.branch)}};
  // Where the plan that is flown goes on, its corridor stays.
  if (!moment.state.draft.extends && !latest.evades) commit["corridor"] = corridor_of(moment);
  commits_.push_back(commit);
}

/// Plans that were too late, or of which nothing could be proven.
void FlightFilm::note_lost(const FlightMoment& moment) {
  const tern::Commitment& draft = moment.state.draft.plan;
  if (moment.state.draft.extends || draft.begin() == shown_ || draft.planned.count == 0) return;
  shown_ = draft.begin();
  dropped_.push_back({{"t", rounded(now(moment))}, {"points", points_of(draft.planned, 0.0)}});
}

RunJson FlightFilm::facts(const FlightResult& result) const {
  RunJson facts = RunJson::array();
  const auto add = [&](const char* label, const std::string& text) { facts.push_back({label, text}); };
  add("status", result.status);
  if (!result.reached()) add("why", result.reason);
  if (result.is_blocked()) add("in the way", result.blocked());
  if (result.narrow.found) add("too narrow", result.narrow.text());
  add("duration", fixed(result.time, 2) + " s");
  add("length", fixed(result.length, 2) + " m");
  if (std::isfinite(result.min_clearance)) {
    add("least clearance",
        fixed(result.min_clearance, 3) + " m; the body's radius is " + fixed(world_.settings.body_radius, 2) + " m");
  }
  if (std::isfinite(result.tracking_max)) {
    add("tracking error",
        fixed(result.tracking_max, 3) + " m at most; margin " + fixed(world_.settings.tracking_margin, 2) + " m");
  }
  if (!world_.things.empty()) {
    add("things that move", std::to_string(world_.things.size()) + "; touched " +
                                std::to_string(result.things.in_motion()) + " in motion, " +
                                std::to_string(result.things.at_rest()) + " at rest");
  }
  add("plans", std::to_string(result.asked) + " asked, " + std::to_string(result.committed) + " committed, " +
                   std::to_string(result.dropped) + " dropped, " + std::to_string(result.failed) + " failed");
  add("work",
      std::to_string(result.work_max) + " units a tick at most, of " + std::to_string(world_.settings.work_per_tick));
  return facts;
}

std::string FlightFilm::run(const FlightResult& result) const {
  const FlightSettings& s = world_.settings;
  const FlightWorld shown = with_appeared(world_, result.appeared);
  RunJson boxes = RunJson::array();
  for (const tern::Box& box : shown.blocks) {
    append_point(boxes, box.lower);
    append_point(boxes, box.upper);
  }
  RunJson cylinders = RunJson::array();
  for (const Cylinder& c : shown.cylinders) {
    for (const double number : {c.x, c.y, c.bottom, c.top, c.radius}) cylinders.push_back(rounded(number));
  }
  const RunJson nothing = RunJson::array();
  const RunJson run = {
      {"kind", "flight"},
      {"name", world_.name.substr(world_.name.find_last_of('/') + 1)},
      {"facts", facts(result)},
      {"boundary", rounded(world_.boundary)},
      {"radius", s.body_radius},
      {"boxes", boxes},
      {"keepout", nothing},
      {"cylinders", cylinders},
      {"fences", fences_json(world_.fences)},
      {"start", rounded(world_.start)},
      {"goal", rounded(world_.goal)},
      {"vias", vias_json(world_.vias)},
      {"things", moving_things_json(world_, result.things)},
      {"blocked", result.is_blocked() ? rounded(result.blocked_at) : nullptr},
      {"limits",
       {{"v", s.v_max}, {"a", s.a_max}, {"j", s.j_max > 0.0 ? RunJson(s.j_max) : nullptr}, {"work", s.work_per_tick}}},
      {"motion", motion_.json(static_cast<double>(stride_) / s.tick_hz)},
      {"film",
       {{"sensor",
         {{"range", s.sensor_range}, {"fov", {s.sensor == "lidar" ? kTurn : s.fov_horizontal, s.fov_vertical}}}},
        {"known", growth_.known_json()},
        {"seen", growth_.seen_json()},
        {"tubes", tubes_json()},
        {"commits", commits_},
        {"dropped", dropped_}}}};
  return run.dump(-1, ' ', false, RunJson::error_handler_t::replace);
}

}  // namespace tern_host
