// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <new>

#include "flight/flight_handle.hpp"
#include "tern/flight_record.hpp"
#include "tern/tern_flight_record.h"

namespace {

using tern::FlightRecorder;
using tern::Status;

/// A tern_flight_recorder's first word once a record was begun there; the recorder follows it.
constexpr std::uint64_t kRecorderTag = 0x7465726E2D726563u;
constexpr std::uint8_t kInvalid = static_cast<std::uint8_t>(Status::kInvalidArgument);

static_assert(sizeof(std::uint64_t) + sizeof(FlightRecorder) <= sizeof(tern_flight_recorder) &&
                  alignof(FlightRecorder) <= alignof(tern_flight_recorder),
              "raise TERN_FLIGHT_RECORDER_WORDS");
static_assert(TERN_FLIGHT_RECORD_BYTES == tern::kFlightRecordBytes && TERN_TICK_RECORD_BYTES == tern::kTickRecordBytes,
              "one size in both languages");

/// Null if there is none. The memory may be uninitialised. A volatile read gives the word one definite value.
FlightRecorder* object(const tern_flight_recorder* place) {
  if (place == nullptr || *static_cast<const volatile std::uint64_t*>(place->opaque) != kRecorderTag) return nullptr;
  const auto* const recorder = std::launder(reinterpret_cast<const FlightRecorder*>(place->opaque + 1));
  return const_cast<FlightRecorder*>(recorder);
}

/// Makes a call of the recorder and returns its answer. `here` is false if a pointer that the call needs is null.
template <typename Call>
std::uint8_t record(tern_flight_recorder* place, bool here, Call call) {
  FlightRecorder* const recorder = object(place);
  return recorder != nullptr && here ? static_cast<std::uint8_t>(call(*recorder)) : kInvalid;
}

Status status(std::uint8_t answer) {
  return static_cast<Status>(answer);
}

}  // namespace

extern "C" {

std::size_t tern_frame_record_bytes(const tern_depth_view* view) {
  return view == nullptr ? 0 : tern::frame_record_bytes(*view);
}

std::size_t tern_scan_record_bytes(std::size_t count) {
  return tern::scan_record_bytes(count);
}

std::uint8_t tern_flight_record_begin(tern_flight_recorder* recorder, std::uint8_t* bytes, std::size_t room) {
  if (recorder == nullptr) return kInvalid;
  FlightRecorder begun;
  const Status answer = begun.begin(bytes, room);
  new (recorder->opaque + 1) FlightRecorder(begun);
  recorder->opaque[0] = kRecorderTag;
  return static_cast<std::uint8_t>(answer);
}

std::uint8_t tern_flight_record_bind(tern_flight_recorder* recorder, const tern_map_spec* spec, std::uint8_t answer) {
  return record(recorder, spec != nullptr, [=](FlightRecorder& r) { return r.bind(*spec, status(answer)); });
}

std::uint8_t tern_flight_record_assume_free(tern_flight_recorder* recorder, const tern_vec3* center, double radius,
                                            std::uint8_t answer) {
  return record(recorder, center != nullptr,
                [=](FlightRecorder& r) { return r.assume_free(*center, radius, status(answer)); });
}

std::uint8_t tern_flight_record_assume_column(tern_flight_recorder* recorder, const tern_cylinder* column,
                                              std::uint8_t answer) {
  return record(recorder, column != nullptr,
                [=](FlightRecorder& r) { return r.assume_column(*column, status(answer)); });
}

std::uint8_t tern_flight_record_mark_box(tern_flight_recorder* recorder, const tern_box* world, std::uint8_t answer) {
  return record(recorder, world != nullptr, [=](FlightRecorder& r) { return r.mark_box(*world, status(answer)); });
}

std::uint8_t tern_flight_record_mark_cylinder(tern_flight_recorder* recorder, const tern_cylinder* world,
                                              std::uint8_t answer) {
  return record(recorder, world != nullptr, [=](FlightRecorder& r) { return r.mark_cylinder(*world, status(answer)); });
}

std::uint8_t tern_flight_record_mark_points(tern_flight_recorder* recorder, const tern_vec3* world, std::size_t count,
                                            std::uint8_t answer) {
  return record(recorder, true, [=](FlightRecorder& r) { return r.mark_points(world, count, status(answer)); });
}

std::uint8_t tern_flight_record_frame(tern_flight_recorder* recorder, const tern_depth_view* view,
                                      const tern_pose* pose, std::int64_t t, std::uint8_t answer) {
  return record(recorder, view != nullptr && pose != nullptr,
                [=](FlightRecorder& r) { return r.frame(*view, *pose, t, status(answer)); });
}

std::uint8_t tern_flight_record_scan(tern_flight_recorder* recorder, const tern_vec3* points, std::size_t count,
                                     const tern_vec3* origin, std::int64_t t, std::uint8_t answer) {
  return record(recorder, origin != nullptr,
                [=](FlightRecorder& r) { return r.scan(points, count, *origin, t, status(answer)); });
}

std::uint8_t tern_flight_record_beams(tern_flight_recorder* recorder, const tern_beams* beams, const tern_vec3* origin,
                                      std::int64_t t, std::uint8_t answer) {
  return record(recorder, beams != nullptr && origin != nullptr,
                [=](FlightRecorder& r) { return r.scan(*beams, *origin, t, status(answer)); });
}

std::uint8_t tern_flight_record_follow(tern_flight_recorder* recorder, const tern_vec3* center, std::uint8_t answer) {
  return record(recorder, center != nullptr, [=](FlightRecorder& r) { return r.follow(*center, status(answer)); });
}

std::uint8_t tern_flight_record_step(tern_flight_recorder* recorder, std::uint32_t work, std::uint8_t answer) {
  return record(recorder, true, [=](FlightRecorder& r) { return r.step(work, status(answer)); });
}

std::uint8_t tern_flight_record_start(tern_flight_recorder* recorder, const tern_flight_spec* spec,
                                      const tern_vec3* position, std::int64_t t, std::uint8_t answer) {
  return record(recorder, spec != nullptr && position != nullptr,
                [=](FlightRecorder& r) { return r.start(*spec, *position, t, status(answer)); });
}

std::uint8_t tern_flight_record_set_goal(tern_flight_recorder* recorder, const tern_vec3* goal, std::uint8_t answer) {
  return record(recorder, goal != nullptr, [=](FlightRecorder& r) { return r.set_goal(*goal, status(answer)); });
}

std::uint8_t tern_flight_record_set_mission(tern_flight_recorder* recorder, const tern_via* points, std::int32_t count,
                                            std::uint8_t policy, std::uint8_t answer) {
  const auto what = static_cast<tern::ViaPolicy>(policy);
  return record(recorder, true, [=](FlightRecorder& r) { return r.set_mission(points, count, what, status(answer)); });
}

std::uint8_t tern_flight_record_land(tern_flight_recorder* recorder, const tern_vec3* place, double ground,
                                     double speed, std::uint8_t answer) {
  return record(recorder, place != nullptr,
                [=](FlightRecorder& r) { return r.land(*place, ground, speed, status(answer)); });
}

std::uint8_t tern_flight_record_set_yaw(tern_flight_recorder* recorder, const tern_flight_yaw* yaw,
                                        std::uint8_t answer) {
  return record(recorder, yaw != nullptr, [=](FlightRecorder& r) { return r.set_yaw(*yaw, status(answer)); });
}

std::uint8_t tern_flight_record_stop(tern_flight_recorder* recorder, std::uint8_t answer) {
  return record(recorder, true, [=](FlightRecorder& r) { return r.stop(status(answer)); });
}

std::uint8_t tern_flight_record_note_position(tern_flight_recorder* recorder, const tern_vec3* position, std::int64_t t,
                                              std::uint8_t answer) {
  return record(recorder, position != nullptr,
                [=](FlightRecorder& r) { return r.note_position(*position, t, status(answer)); });
}

std::uint8_t tern_flight_record_set_clock(tern_flight_recorder* recorder, std::int64_t t, std::uint8_t answer) {
  return record(recorder, true, [=](FlightRecorder& r) { return r.set_clock(t, status(answer)); });
}

std::uint8_t tern_flight_record_update_track(tern_flight_recorder* recorder, const tern_track* track,
                                             std::uint8_t answer) {
  return record(recorder, track != nullptr, [=](FlightRecorder& r) { return r.update_track(*track, status(answer)); });
}

std::uint8_t tern_flight_record_forget_track(tern_flight_recorder* recorder, std::uint32_t id, std::uint8_t answer) {
  return record(recorder, true, [=](FlightRecorder& r) { return r.forget_track(id, status(answer)); });
}

std::uint8_t tern_flight_record_answer(tern_flight_recorder* recorder, std::uint32_t number, bool may_fly,
                                       std::uint8_t answer) {
  return record(recorder, true, [=](FlightRecorder& r) { return r.answer(number, may_fly, status(answer)); });
}

std::uint8_t tern_flight_record_set_clearance(tern_flight_recorder* recorder, std::int64_t clearance,
                                              std::uint8_t answer) {
  return record(recorder, true, [=](FlightRecorder& r) { return r.set_clearance(clearance, status(answer)); });
}

std::uint8_t tern_flight_record_tick(tern_flight_recorder* recorder, const tern_flight* flight, std::int64_t t,
                                     const tern_flight_report* report, std::uint8_t answer) {
  return record(recorder, flight != nullptr && report != nullptr,
                [=](FlightRecorder& r) { return r.tick(tern::object(flight), t, *report, status(answer)); });
}

std::uint8_t tern_flight_record_close(tern_flight_recorder* recorder, std::size_t* used) {
  return record(recorder, true, [=](FlightRecorder& r) { return r.close(used); });
}

std::size_t tern_flight_record_pending(const tern_flight_recorder* recorder) {
  const FlightRecorder* const begun = object(recorder);
  return begun == nullptr ? 0 : begun->pending();
}

void tern_flight_record_clear(tern_flight_recorder* recorder) {
  FlightRecorder* const begun = object(recorder);
  if (begun != nullptr) begun->clear();
}

}  // extern "C"
