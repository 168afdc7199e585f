// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <new>

#include "flight/flight_handle.hpp"
#include "grid/grid_handle.hpp"
#include "map/map_handle.hpp"
#include "tern/from_beyond.hpp"

namespace {

using tern::Flight;
using tern::kFlightTag;
using tern::object;
using tern::Status;

constexpr std::uint8_t kInvalid = static_cast<std::uint8_t>(Status::kInvalidArgument);

static_assert(sizeof(std::uint64_t) + sizeof(Flight) <= sizeof(tern_flight) && alignof(Flight) <= alignof(tern_flight),
              "raise TERN_FLIGHT_WORDS");

std::uint8_t code(Status status) {
  return static_cast<std::uint8_t>(status);
}

}  // namespace

extern "C" {

double tern_clear_until(const tern_grid* grid, const tern_trajectory* trajectory, double from,
                        const tern_limits* limits, std::uint8_t beyond, tern_proof_report* report) {
  if (grid == nullptr || trajectory == nullptr) return __builtin_nan("");
  const tern::Beyond space = beyond == TERN_BEYOND_EMPTY ? tern::Beyond::kEmpty : tern::Beyond::kSolid;
  return tern::clear_until(object(grid), *trajectory, from, limits, space, report);
}

void tern_flight_spec_init(tern_flight_spec* spec, const tern_limits* limits) {
  if (spec == nullptr || limits == nullptr) return;
  *spec = tern::flight_spec(*limits);
}

std::uint8_t tern_limit_speed(double range, double delay, double speed, double size, const tern_flight_spec* spec,
                              double clearance, tern_limits* limits, tern_trajectory* room) {
  if (spec == nullptr || limits == nullptr || room == nullptr) return kInvalid;
  return code(tern::limit_speed({range, delay, speed, size}, *spec, clearance, *limits, *room));
}

std::size_t tern_flight_words(tern_voxel dims) {
  return tern::flight_words(dims);
}

std::uint8_t tern_flight_start(tern_flight* flight, const tern_flight_spec* spec, const tern_map* map,
                               tern_planner* planner, std::uint64_t* words, std::size_t word_count,
                               const tern_vec3* position, std::int64_t t, tern_flight_refusal* refusal) {
  if (refusal != nullptr) *refusal = tern::FlightRefusal{};
  if (flight == nullptr || spec == nullptr || map == nullptr || planner == nullptr || position == nullptr) {
    return kInvalid;
  }
  tern::Planner& plans = *std::launder(reinterpret_cast<tern::Planner*>(planner->opaque));
  Flight begun;
  const Status status = begun.start(*spec, object(map), plans, words, word_count, *position, t, refusal);
  if (status != Status::kOk) return code(status);
  new (flight->opaque + 1) Flight(begun);
  flight->opaque[0] = kFlightTag;
  return code(status);
}

std::uint8_t tern_flight_set_goal(tern_flight* flight, const tern_vec3* goal) {
  return goal == nullptr ? kInvalid : code(object(flight).set_goal(*goal));
}

std::uint8_t tern_flight_check_goal(const tern_flight* flight, const tern_vec3* goal, tern_flight_refusal* why) {
  return goal == nullptr ? kInvalid : code(object(flight).check_goal(*goal, why));
}

std::uint8_t tern_flight_set_mission(tern_flight* flight, const tern_via* points, std::int32_t count,
                                     std::uint8_t policy) {
  return code(object(flight).set_mission(points, count, static_cast<tern::ViaPolicy>(policy)));
}

std::uint8_t tern_flight_land(tern_flight* flight, const tern_vec3* place, double ground, double speed) {
  return place == nullptr ? kInvalid : code(object(flight).land(*place, ground, speed));
}

std::uint8_t tern_flight_point_state(const tern_flight* flight, std::int32_t point) {
  return static_cast<std::uint8_t>(object(flight).point_state(point));
}

std::int32_t tern_flight_looked_in_vain(const tern_flight* flight, tern_unseen_voxel* voxels, std::int32_t capacity) {
  return object(flight).looked_in_vain(voxels, voxels == nullptr ? 0 : capacity);
}

std::uint8_t tern_flight_stop(tern_flight* flight) {
  return code(object(flight).stop());
}

std::uint8_t tern_flight_tick(tern_flight* flight, std::int64_t t, tern_flight_report* report) {
  return code(report != nullptr ? object(flight).tick(t, *report) : object(flight).tick(t));
}

void tern_flight_command(const tern_flight* flight, std::int64_t t, tern_command* command) {
  if (command != nullptr) *command = object(flight).command(t);
}

std::uint8_t tern_flight_note_position(tern_flight* flight, const tern_vec3* position, std::int64_t t) {
  return position == nullptr ? kInvalid : code(object(flight).note_position(*position, t));
}

std::uint8_t tern_flight_update_track(tern_flight* flight, const tern_track* track) {
  return track == nullptr ? kInvalid : code(object(flight).update_track(*track));
}

std::uint8_t tern_flight_forget_track(tern_flight* flight, std::uint32_t id) {
  return code(object(flight).forget_track(id));
}

std::uint32_t tern_flight_proposal(const tern_flight* flight, tern_trajectory* plan, std::int64_t* takeover) {
  return plan == nullptr || takeover == nullptr ? 0 : object(flight).proposal(*plan, *takeover);
}

std::uint8_t tern_flight_answer(tern_flight* flight, std::uint32_t number, bool may_fly) {
  return code(object(flight).answer(number, may_fly));
}

std::int64_t tern_flight_rest_clear_until(const tern_flight* flight) {
  return object(flight).rest_clear_until();
}

std::uint8_t tern_flight_set_clearance(tern_flight* flight, std::int64_t clearance) {
  return code(object(flight).set_clearance(clearance));
}

std::uint8_t tern_flight_set_clock(tern_flight* flight, std::int64_t t) {
  return code(object(flight).set_clock(t));
}

std::uint8_t tern_flight_committed_plan(const tern_flight* flight, tern_trajectory* plan) {
  return plan == nullptr ? kInvalid : code(object(flight).committed_plan(*plan));
}

void tern_flight_rest_position(const tern_flight* flight, tern_vec3* position) {
  if (position != nullptr) *position = object(flight).rest_position();
}

std::uint8_t tern_flight_set_yaw(tern_flight* flight, const tern_flight_yaw* yaw) {
  return yaw == nullptr ? kInvalid : code(object(flight).set_yaw(*yaw));
}

void tern_flight_yaw_at(const tern_flight* flight, std::int64_t t, tern_yaw_sample* yaw) {
  if (yaw != nullptr) *yaw = object(flight).yaw(t);
}

const char* tern_flight_mode_name(std::uint8_t mode) {
  return tern::flight_mode_name(static_cast<tern::FlightMode>(mode));
}

const char* tern_flight_reason_text(std::uint8_t reason) {
  return tern::flight_reason_text(static_cast<tern::FlightReason>(reason));
}

const char* tern_blocked_by_text(std::uint8_t by) {
  return tern::blocked_by_text(static_cast<tern::BlockedBy>(by));
}

}  // extern "C"
