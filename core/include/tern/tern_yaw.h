/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Yaw plans for C99: tern::YawPlanner under C names. tern/yaw.hpp explains every field and answer. */
#ifndef TERN_TERN_YAW_H
#define TERN_TERN_YAW_H

#include "tern/tern.h"

#ifdef __cplusplus
#include "tern/yaw.hpp"
typedef tern::Heading tern_heading;
typedef tern::TimedHeading tern_timed_heading;
typedef tern::YawRequest tern_yaw_request;
typedef tern::YawSample tern_yaw_sample;
typedef tern::YawPlan tern_yaw_plan;
extern "C" {
#else
/* clang-format off */
/* A direction seen from above, by cosine and sine of any common scale: tern::Heading. */
typedef struct { double cosine, sine; } tern_heading;
/* A heading to have at a time, seconds: tern::TimedHeading. */
typedef struct { double time; tern_heading heading; } tern_timed_heading;
/* What to plan: tern::YawRequest. Fill it in after tern_yaw_request_init(). rad/s, rad/s^2, m, m/s. */
typedef struct {
  uint8_t mode; /* TERN_YAW_... */
  double rate_max, acceleration_max;
  tern_heading start; double start_rate, start_acceleration;
  tern_heading heading;             /* for TERN_YAW_FIXED */
  tern_vec3 point;                  /* for TERN_YAW_TOWARDS_POINT */
  const tern_timed_heading* timed;  /* for TERN_YAW_TIMED: yours until the plan is finished */
  int32_t timed_count;
  double least_speed, least_distance;
} tern_yaw_request;
/* The heading at one time: tern::YawSample. rad, rad/s, rad/s^2. */
typedef struct { tern_yaw yaw; double acceleration, angle; } tern_yaw_sample;
/* A yaw plan: tern::YawPlan. */
typedef struct {
  int32_t count; double lead, polynomial[4], step, points[TERN_MAX_YAW_PIECES + 3];
} tern_yaw_plan;
/* clang-format on */
#endif

/* What the nose should point at. */
enum {
  TERN_YAW_FIXED = 0,         /* a heading */
  TERN_YAW_ALONG_MOTION = 1,  /* the horizontal velocity */
  TERN_YAW_TOWARDS_POINT = 2, /* a point, seen from above */
  TERN_YAW_TIMED = 3          /* headings at times */
};

/* Size of tern_yaw_planner in words of 64 bits. The core asserts that it suffices. */
#define TERN_YAW_PLANNER_WORDS (12 * TERN_MAX_YAW_PIECES + 64)

/* A planner of yaws: an object of the library in memory of yours, too large for a small stack. It may hold anything
 * before its first tern_yaw_plan_begin(). Zero it if another call can come first: that call then answers
 * invalid_argument. */
typedef struct {
  uint64_t opaque[TERN_YAW_PLANNER_WORDS];
} tern_yaw_planner;

/* Common values: tern::yaw_request(). Null does nothing. */
void tern_yaw_request_init(tern_yaw_request* request, const tern_heading* start, double rate_max,
                           double acceleration_max);
/* The yaw plan for a trajectory. ok, non_finite_input, limits_invalid, invalid_argument or start_exceeds_limits. */
uint8_t tern_plan_yaw(tern_yaw_planner* planner, const tern_trajectory* trajectory, const tern_yaw_request* request,
                      tern_yaw_plan* plan);
/* Begins a yaw plan in slices. The trajectory and the timed headings must stay as they are until
 * tern_yaw_plan_finish(). */
uint8_t tern_yaw_plan_begin(tern_yaw_planner* planner, const tern_trajectory* trajectory,
                            const tern_yaw_request* request);
/* Spends at most `work` units. running, ok or invalid_argument. */
uint8_t tern_yaw_plan_step(tern_yaw_planner* planner, uint32_t work);
/* Hands over the plan, or the plan so far. ok or invalid_argument. */
uint8_t tern_yaw_plan_finish(tern_yaw_planner* planner, tern_yaw_plan* plan);
/* Duration in seconds: the trajectory's, and the time of half a turn. The nose may rest earlier. 0 for null. */
double tern_yaw_duration(const tern_yaw_plan* plan);
/* The heading at `t`: any time has an answer. For a null plan, that of an empty one. */
void tern_yaw_evaluate(const tern_yaw_plan* plan, double t, tern_yaw_sample* sample);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
