/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Records of flights for C99: tern::FlightRecorder under C names. tern/flight_record.hpp explains them.
 *
 * Make each call of the map and the flight as always, then tell the recorder of it, with its answer. Every call
 * below answers ok, record_full or invalid_argument. */
#ifndef TERN_TERN_FLIGHT_RECORD_H
#define TERN_TERN_FLIGHT_RECORD_H

#include "tern/tern_flight.h"
#include "tern/tern_map.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Size of tern_flight_recorder in words of 64 bits. The core asserts that it suffices. */
#define TERN_FLIGHT_RECORDER_WORDS 8

/* A recorder: an object of the library in memory of yours. It may hold anything before its begin. Zero it if another
 * call can come first. */
typedef struct {
  uint64_t opaque[TERN_FLIGHT_RECORDER_WORDS];
} tern_flight_recorder;

/* Room that is enough for begin and close, and that a tick needs, bytes. */
#define TERN_FLIGHT_RECORD_BYTES 56
#define TERN_TICK_RECORD_BYTES 168
/* Room that is enough for a frame with such a view, and for a scan of so many points or beams, bytes. */
size_t tern_frame_record_bytes(const tern_depth_view* view);
size_t tern_scan_record_bytes(size_t count);

/* Begins a record in `room` bytes of yours. */
uint8_t tern_flight_record_begin(tern_flight_recorder* recorder, uint8_t* bytes, size_t room);

/* The map. */
uint8_t tern_flight_record_bind(tern_flight_recorder* recorder, const tern_map_spec* spec, uint8_t answer);
uint8_t tern_flight_record_assume_free(tern_flight_recorder* recorder, const tern_vec3* center, double radius,
                                       uint8_t answer);
uint8_t tern_flight_record_assume_column(tern_flight_recorder* recorder, const tern_cylinder* column, uint8_t answer);
uint8_t tern_flight_record_mark_box(tern_flight_recorder* recorder, const tern_box* world, uint8_t answer);
uint8_t tern_flight_record_mark_cylinder(tern_flight_recorder* recorder, const tern_cylinder* world, uint8_t answer);
uint8_t tern_flight_record_mark_points(tern_flight_recorder* recorder, const tern_vec3* world, size_t count,
                                       uint8_t answer);
uint8_t tern_flight_record_frame(tern_flight_recorder* recorder, const tern_depth_view* view, const tern_pose* pose,
                                 int64_t t, uint8_t answer);
uint8_t tern_flight_record_scan(tern_flight_recorder* recorder, const tern_vec3* points, size_t count,
                                const tern_vec3* origin, int64_t t, uint8_t answer);
uint8_t tern_flight_record_beams(tern_flight_recorder* recorder, const tern_beams* beams, const tern_vec3* origin,
                                 int64_t t, uint8_t answer);
uint8_t tern_flight_record_follow(tern_flight_recorder* recorder, const tern_vec3* center, uint8_t answer);
uint8_t tern_flight_record_step(tern_flight_recorder* recorder, uint32_t work, uint8_t answer);

/* The flight. */
uint8_t tern_flight_record_start(tern_flight_recorder* recorder, const tern_flight_spec* spec,
                                 const tern_vec3* position, int64_t t, uint8_t answer);
uint8_t tern_flight_record_set_goal(tern_flight_recorder* recorder, const tern_vec3* goal, uint8_t answer);
uint8_t tern_flight_record_set_mission(tern_flight_recorder* recorder, const tern_via* points, int32_t count,
                                       uint8_t policy, uint8_t answer);
uint8_t tern_flight_record_land(tern_flight_recorder* recorder, const tern_vec3* place, double ground, double speed,
                                uint8_t answer);
uint8_t tern_flight_record_set_yaw(tern_flight_recorder* recorder, const tern_flight_yaw* yaw, uint8_t answer);
uint8_t tern_flight_record_stop(tern_flight_recorder* recorder, uint8_t answer);
uint8_t tern_flight_record_note_position(tern_flight_recorder* recorder, const tern_vec3* position, int64_t t,
                                         uint8_t answer);
uint8_t tern_flight_record_set_clock(tern_flight_recorder* recorder, int64_t t, uint8_t answer);
uint8_t tern_flight_record_update_track(tern_flight_recorder* recorder, const tern_track* track, uint8_t answer);
uint8_t tern_flight_record_forget_track(tern_flight_recorder* recorder, uint32_t id, uint8_t answer);
uint8_t tern_flight_record_answer(tern_flight_recorder* recorder, uint32_t number, bool may_fly, uint8_t answer);
uint8_t tern_flight_record_set_clearance(tern_flight_recorder* recorder, int64_t clearance, uint8_t answer);
uint8_t tern_flight_record_tick(tern_flight_recorder* recorder, const tern_flight* flight, int64_t t,
                                const tern_flight_report* report, uint8_t answer);

/* Makes the bytes so far a whole record; calls may go on. */
uint8_t tern_flight_record_close(tern_flight_recorder* recorder, size_t* used);
/* To stream a record: the bytes in the buffer, without those of close, and the call that empties the buffer once they
 * are saved. */
size_t tern_flight_record_pending(const tern_flight_recorder* recorder);
void tern_flight_record_clear(tern_flight_recorder* recorder);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
