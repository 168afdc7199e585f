/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Corridors for C99: tern::Polyhedron under a C name, for displays and logs. tern/corridor.hpp explains every field. */
#ifndef TERN_TERN_CORRIDOR_H
#define TERN_TERN_CORRIDOR_H

#include "tern/tern.h"

#ifdef __cplusplus
#include "tern/corridor.hpp"
typedef tern::Polyhedron tern_polyhedron;
extern "C" {
#else
/* clang-format off */
/* Free space for the robot's centre: tern::Polyhedron. The first `count` planes bound it. Relative to the grid's
 * origin. */
typedef struct { int count; tern_halfspace planes[TERN_MAX_PLANES]; tern_vec3 from, to; } tern_polyhedron;
/* clang-format on */
#endif

/* Copies the first `room` polyhedra of the last plan's corridor, in flight order. Returns how many the corridor has: at
 * most TERN_MAX_SEGMENTS, and 0 if the last plan has no corridor. `polyhedra` may be null if room is 0. The field
 * `polyhedron` of a tern_segment is an index into them, or -1. Call it before the planner's next plan. */
int32_t tern_corridor(const tern_planner* planner, tern_polyhedron* polyhedra, int32_t room);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
