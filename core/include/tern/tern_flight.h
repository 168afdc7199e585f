/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Proofs and flights for C99: tern::clear_until and tern::Flight under C names. tern/proof.hpp and tern/flight.hpp
 * explain every field and answer.
 *
 * In order: bind a map (tern/tern_map.h) and tell it what is free around the vehicle, initialise a planner, start a
 * flight over both, set a goal, then enter frames, call tern_flight_tick() at a constant rate and fly the commands of
 * tern_flight_command(). */
#ifndef TERN_TERN_FLIGHT_H
#define TERN_TERN_FLIGHT_H

#include "tern/tern_map.h"
#include "tern/tern_yaw.h"

#ifdef __cplusplus
#include "tern/flight.hpp"
#include "tern/proof.hpp"
typedef tern::FlightSensor tern_flight_sensor;
typedef tern::FlightSpec tern_flight_spec;
typedef tern::FlightRefusal tern_flight_refusal;
typedef tern::UnseenVoxel tern_unseen_voxel;
typedef tern::FlightReport tern_flight_report;
typedef tern::FlightYaw tern_flight_yaw;
typedef tern::Command tern_command;
extern "C" {
#else
/* clang-format off */
/* What the sensor sees: tern::FlightSensor. rad, m. */
typedef struct {
  double horizontal, vertical, pitch_min, pitch_max, nearest;
  tern_vec3 offset;
  double raised;
} tern_flight_sensor;
/* How to fly: tern::FlightSpec. SI units; tick in nanoseconds. */
typedef struct {
  tern_limits limits; double time_weight; int64_t tick; uint32_t work_per_tick, plan_work;
  double horizon, near, yaw_rate;
  const tern_fence* fences; int32_t fence_count;
  int64_t stale_after; /* nanoseconds */
  tern_flight_sensor sensor;
  int64_t clearance; /* nanoseconds */
} tern_flight_spec;
/* Why a flight was refused: tern::FlightRefusal. */
typedef struct {
  uint8_t field; int32_t fence;
  uint8_t blocked_by; /* TERN_BLOCKED_BY_... */
  tern_vec3 blocked_at; double distance, needed; /* metres */
} tern_flight_refusal;
/* A voxel that was looked at in vain: tern::UnseenVoxel. */
typedef struct {
  tern_vec3 center; int32_t views; tern_vec3 directions[4];
} tern_unseen_voxel;
/* What one tick did: tern::FlightReport. */
typedef struct {
  uint8_t mode, reason, plan;
  uint32_t asked, committed, dropped, failed, work;
  int64_t contact_time; double contact_speed;
  int32_t leg, passed, skipped;
  bool waits_for_nose, map_stale; int64_t frame_age;
  uint8_t blocked_by; /* TERN_BLOCKED_BY_... */
  tern_vec3 blocked_at; int32_t blocked_fence;
  double stray, speed_share; /* metres; 1 at full speed */
} tern_flight_report;
/* How to turn the nose: tern::FlightYaw. rad, rad/s^2, m. */
typedef struct {
  uint8_t mode; /* TERN_FLIGHT_YAW_... */
  double acceleration_max, field_of_view;
  tern_heading start, heading; tern_vec3 point;
  const tern_heading* headings; int32_t heading_count;
} tern_flight_yaw;
/* The command for one time: tern::Command. */
typedef struct { tern_sample sample; tern_vec3 look_at; } tern_command;
/* clang-format on */
#endif

/* What a proof assumes beyond the boundary: nothing, or that all is solid. */
enum { TERN_BEYOND_EMPTY = 0, TERN_BEYOND_SOLID = 1 };
/* What ends a proof: tern::Finding. A plan is also refused for a missed start, goal (8) or via (10). */
enum {
  TERN_FINDING_NONE = 0,         /* nothing: all of it is proven */
  TERN_FINDING_MALFORMED = 1,    /* no trajectory at all */
  TERN_FINDING_OBSTACLE = 2,     /* an obstacle that is too near */
  TERN_FINDING_OUTSIDE = 3,      /* the boundary */
  TERN_FINDING_VELOCITY = 4,     /* a limit of velocity */
  TERN_FINDING_ACCELERATION = 5, /* a limit of acceleration */
  TERN_FINDING_JOINT = 6,        /* a gap between two segments */
  TERN_FINDING_FENCE = 7,        /* a fence */
  TERN_FINDING_JERK = 9,         /* a limit of jerk */
  TERN_FINDING_PIECES = 11       /* a segment that needs too many pieces */
};
/* What the vehicle is doing. */
enum {
  TERN_FLIGHT_REST = 0,  /* hovering */
  TERN_FLIGHT_LOOK = 1,  /* hovering and looking around */
  TERN_FLIGHT_FLY = 2,   /* on the way */
  TERN_FLIGHT_STOP = 3,  /* on a brake */
  TERN_FLIGHT_THREAT = 4 /* the committed plan is no longer proven */
};
/* Why the vehicle rests, or flies slower. */
enum {
  TERN_FLIGHT_GOES_ON = 0,          /* it flies, or is about to */
  TERN_FLIGHT_NO_GOAL = 1,          /* there is no goal */
  TERN_FLIGHT_ARRIVED = 2,          /* at the goal */
  TERN_FLIGHT_NEAREST = 3,          /* as near as it gets to a goal that is occupied or cut off */
  TERN_FLIGHT_NO_PROGRESS = 4,      /* there is no way that can be proven */
  TERN_FLIGHT_HEMMED_IN = 5,        /* there is no way that can be proven, and something is nearer than the radius */
  TERN_FLIGHT_VIA_BLOCKED = 6,      /* the mission's next point is occupied or fenced */
  TERN_FLIGHT_VIA_UNREACHABLE = 7,  /* there is no way to the mission's next point */
  TERN_FLIGHT_MAP_STALE = 8,        /* no frames come, and there is no way through known space */
  TERN_FLIGHT_STRAYS = 9,           /* it flies slower: it strays by more than 60 % of the tracking margin */
  TERN_FLIGHT_MARGIN_EXCEEDED = 10, /* likewise, and it strayed by more than the margin */
  TERN_FLIGHT_LANDED = 11,          /* it stands where it was to land */
  TERN_FLIGHT_GROUND_UNSEEN = 12,   /* it cannot land: the ground there was not seen */
  TERN_FLIGHT_GROUND_UNEVEN = 13,   /* it cannot land: the ground there is not flat, or something is on it */
  TERN_FLIGHT_GOAL_UNSEEN = 14,     /* no progress: what the way to the goal needs can be seen from nowhere */
  TERN_FLIGHT_HELD_UP = 15          /* things that move have kept it from going on, or pushed it, for a minute */
};
/* What keeps the flight from going on. */
enum {
  TERN_BLOCKED_BY_NOTHING = 0,
  TERN_BLOCKED_BY_UNSEEN = 1,   /* a voxel that no sensor has shown to be free yet */
  TERN_BLOCKED_BY_OBSTACLE = 2, /* a voxel with something that was seen or marked */
  TERN_BLOCKED_BY_WINDOW = 3,   /* the face of the map's window */
  TERN_BLOCKED_BY_FENCE = 4,
  TERN_BLOCKED_BY_TRACK = 5 /* something that moves */
};
/* What happens if a point of a mission cannot be reached. */
enum { TERN_VIA_END = 0 /* the mission ends */, TERN_VIA_SKIP = 1 /* the flight goes on to the next point */ };
/* Where the nose points in flight. */
enum {
  TERN_FLIGHT_YAW_TOWARDS_UNSEEN = 0, /* to the first point of the way that is not proven yet */
  TERN_FLIGHT_YAW_ALONG_MOTION = 1,
  TERN_FLIGHT_YAW_TOWARDS_POINT = 2,
  TERN_FLIGHT_YAW_FIXED = 3,
  TERN_FLIGHT_YAW_AT_POINTS = 4 /* each point of the mission with a heading of its own */
};
/* What became of a point of a mission. */
enum { TERN_POINT_AHEAD = 0, TERN_POINT_PASSED = 1, TERN_POINT_SKIPPED = 2 };

/* Until when the trajectory is proven from `from` on, in seconds since its beginning. `limits` and `report` may be
 * null. NaN for a null grid or trajectory. */
double tern_clear_until(const tern_grid* grid, const tern_trajectory* trajectory, double from,
                        const tern_limits* limits, uint8_t beyond, tern_proof_report* report);

/* Size of tern_flight in words of 64 bits. The core asserts that it suffices. */
#define TERN_FLIGHT_WORDS 2

/* A flight: an object of the library in memory of yours. It may hold anything before its first start. Zero it if
 * another call can come first: that call then answers invalid_argument. Copies share the flight. */
typedef struct {
  uint64_t opaque[TERN_FLIGHT_WORDS];
} tern_flight;

/* Common values: tern::flight_spec(). Null does nothing. */
void tern_flight_spec_init(tern_flight_spec* spec, const tern_limits* limits);
/* Lowers the limits of speed until a vehicle is at rest before it meets what may come from beyond the range of a
   detector: tern::limit_speed. range: m; delay: s; speed: m/s; size: m; clearance: radius + tracking_margin of the map,
   m; room: memory, whose content is lost. ok; non_finite_input; invalid_argument; limits_invalid if the range is too
   short. */
uint8_t tern_limit_speed(double range, double delay, double speed, double size, const tern_flight_spec* spec,
                         double clearance, tern_limits* limits, tern_trajectory* room);
/* Words of 64 bits that a flight over a map of these dimensions needs; 0 if they are out of range. */
size_t tern_flight_words(tern_voxel dims);
/* Begins a flight at rest. Map, planner and words must outlive it. ok, non_finite_input, invalid_argument,
 * limits_invalid, fences_full, fence_planes_full, fence_empty, start_occupied or start_fenced. `refusal` receives what
 * is wrong; it may be null. */
uint8_t tern_flight_start(tern_flight* flight, const tern_flight_spec* spec, const tern_map* map, tern_planner* planner,
                          uint64_t* words, size_t word_count, const tern_vec3* position, int64_t t,
                          tern_flight_refusal* refusal);
/* Sets the goal. ok, non_finite_input or invalid_argument. */
uint8_t tern_flight_set_goal(tern_flight* flight, const tern_vec3* goal);
/* What is known of a goal at once: ok, goal_occupied, goal_fenced, non_finite_input or invalid_argument. `why` receives
 * what is in the way; it may be null. */
uint8_t tern_flight_check_goal(const tern_flight* flight, const tern_vec3* goal, tern_flight_refusal* why);
/* Sets a mission: vias, and the goal as the last point, whose tolerance and stop mean nothing. ok, non_finite_input,
 * vias_full or invalid_argument. */
uint8_t tern_flight_set_mission(tern_flight* flight, const tern_via* points, int32_t count, uint8_t policy);
/* Flies to the point above `place`, then descends straight to it at most at `speed`, m/s. `place`: of the vehicle's
 * centre once it stands; `ground`: a height that the ground there does not exceed. ok, non_finite_input or
 * invalid_argument. */
uint8_t tern_flight_land(tern_flight* flight, const tern_vec3* place, double ground, double speed);
/* What became of a point of the mission. */
uint8_t tern_flight_point_state(const tern_flight* flight, int32_t point);
/* The voxels that were looked at in vain: writes the first `capacity` of them, and returns how many there are. */
int32_t tern_flight_looked_in_vain(const tern_flight* flight, tern_unseen_voxel* voxels, int32_t capacity);
/* Comes to rest and forgets the goal. */
uint8_t tern_flight_stop(tern_flight* flight);
/* One tick's work; `t` in nanoseconds. `report` may be null. ok; clock_behind if `t` is before the last tick's, and
 * nothing was done; invalid_argument. */
uint8_t tern_flight_tick(tern_flight* flight, int64_t t, tern_flight_report* report);
/* The command for time `t`. Any time has an answer; a time before the last tick gets the answer for the last tick. Null
 * does nothing. */
void tern_flight_command(const tern_flight* flight, int64_t t, tern_command* command);
/* Where the vehicle was measured to be at time `t`. ok, non_finite_input or invalid_argument. */
uint8_t tern_flight_note_position(tern_flight* flight, const tern_vec3* position, int64_t t);
/* A measurement of a thing that moves, in place of its last one: tern::Flight::update_track(). ok, non_finite_input,
 * tracks_full, clock_behind or invalid_argument. */
uint8_t tern_flight_update_track(tern_flight* flight, const tern_track* track);
/* That thing is gone for certain. ok or invalid_argument. */
uint8_t tern_flight_forget_track(tern_flight* flight, uint32_t id);
/* The plan that waits for its clearance, when it would take over, and the number of that question; 0 if none waits, or
 * for a null pointer: tern::Flight::proposal(). */
uint32_t tern_flight_proposal(const tern_flight* flight, tern_trajectory* plan, int64_t* takeover);
/* Answers that question. ok, or invalid_argument if no plan with this number waits. */
uint8_t tern_flight_answer(tern_flight* flight, uint32_t number, bool may_fly);
/* Gives answers so many nanoseconds, from the next plan on. ok; invalid_argument if not above 0 and at most 10 s, or if
   the flight's plans need no clearance. */
uint8_t tern_flight_set_clearance(tern_flight* flight, int64_t clearance);
/* Until when the place where the committed plan ends stays clear of all things that move, and of fences for a
   while; INT64_MAX: for long. */
int64_t tern_flight_rest_clear_until(const tern_flight* flight);
/* The clock was set and shows `t` now, one tick after the last one. ok or invalid_argument. */
uint8_t tern_flight_set_clock(tern_flight* flight, int64_t t);

/* The latest committed plan. Its `begin` is the takeover, on the clock of the ticks. ok or invalid_argument. */
uint8_t tern_flight_committed_plan(const tern_flight* flight, tern_trajectory* plan);
/* Where the vehicle comes to rest on the committed plan, metres; zero for a flight that was not started. Null does
 * nothing. */
void tern_flight_rest_position(const tern_flight* flight, tern_vec3* position);

/* Plans yaws beside the committed plans. ok, non_finite_input, limits_invalid or invalid_argument. */
uint8_t tern_flight_set_yaw(tern_flight* flight, const tern_flight_yaw* yaw);
/* Where the nose points at time `t`; the angle counts whole turns. Null does nothing. */
void tern_flight_yaw_at(const tern_flight* flight, int64_t t, tern_yaw_sample* yaw);

/* In English: tern::flight_mode_name(), flight_reason_text() and blocked_by_text(). */
const char* tern_flight_mode_name(uint8_t mode);
const char* tern_flight_reason_text(uint8_t reason);
const char* tern_blocked_by_text(uint8_t by);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
