/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Far ways for C99: tern::FarWay under C names. tern/far_way.hpp explains every field and answer.
 *
 * In this order: bind a coarse grid, mark what is known and inflate it, start a far way with it and a planner of its
 * own, and set the goal. Then call tern_far_way_tick before each tern_flight_tick. */
#ifndef TERN_TERN_FAR_WAY_H
#define TERN_TERN_FAR_WAY_H

#include "tern/tern_flight.h"

#ifdef __cplusplus
#include "tern/far_way.hpp"
/* How a far way leads: metres, nanoseconds. */
typedef tern::FarWaySpec tern_far_way_spec;
extern "C" {
#else
/* How a far way leads: tern::FarWaySpec. Metres, nanoseconds. */
typedef struct {
  double ahead;
  int64_t patience;
} tern_far_way_spec;
#endif

/* What a far way is doing: tern::FarState. */
enum { TERN_FAR_NO_GOAL = 0, TERN_FAR_SEARCHING = 1, TERN_FAR_LEADS = 2, TERN_FAR_NO_WAY = 3 };

/* Size of tern_far_way in words of 64 bits. The core asserts that it suffices. */
#define TERN_FAR_WAY_WORDS 40

/* A far way: an object of the library in memory of yours. It may hold anything before its first start. Zero it if
 * another call can come before that. */
typedef struct {
  uint64_t opaque[TERN_FAR_WAY_WORDS];
} tern_far_way;

/* Begins without a goal. Grid and planner must stay at their addresses. ok, non_finite_input or invalid_argument: also
 * where `ahead` is less than three cells of the grid, or more than 256. */
uint8_t tern_far_way_start(tern_far_way* far_way, const tern_far_way_spec* spec, tern_grid* coarse,
                           tern_planner* planner);
/* Sets the goal, world frame. ok, non_finite_input or invalid_argument. */
uint8_t tern_far_way_set_goal(tern_far_way* far_way, const tern_vec3* goal);
/* Does one tick's work. `report` is the last one of tern_flight_tick; zeros before the first. True: set the flight's
 * goal to `near_goal` now, which receives it, as whenever this answers true. False for null pointers, and before start.
 */
bool tern_far_way_tick(tern_far_way* far_way, const tern_vec3* position, const tern_flight_report* report,
                       const tern_map* map, int64_t t, uint32_t work, tern_vec3* near_goal);
/* True if the near goal is the goal; and before start. */
bool tern_far_way_is_last(const tern_far_way* far_way);
/* TERN_FAR_...; TERN_FAR_NO_GOAL before start. */
uint8_t tern_far_way_state(const tern_far_way* far_way);
/* Metres along the way to its end; 0 unless it leads. */
double tern_far_way_left(const tern_far_way* far_way);
/* Ways sought, and cells of the coarse grid marked, since start. */
int32_t tern_far_way_searches(const tern_far_way* far_way);
int32_t tern_far_way_marked(const tern_far_way* far_way);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
