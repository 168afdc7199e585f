/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * The rolling map for C99: tern::RollingMap under C names. tern/map.hpp explains every field and answer.
 *
 * In this order: fill in a spec (tern_map_spec_init), bind a map to words of yours, call tern_map_assume_free for the
 * place where the vehicle stands, enter frames or scans, and plan on the map's grids. */
#ifndef TERN_TERN_MAP_H
#define TERN_TERN_MAP_H

#include "tern/tern.h"

#ifdef __cplusplus
#include "tern/map.hpp"
typedef tern::MapSpec tern_map_spec;
typedef tern::Pose tern_pose;
typedef tern::DepthView tern_depth_view;
typedef tern::Beams tern_beams;
extern "C" {
#else
/* clang-format off */
/* The window, its resolution, and the errors of the sensor: tern::MapSpec. Metres, radians, nanoseconds. */
typedef struct {
  tern_vec3 origin; double cell; tern_voxel dims; double radius, tracking_margin;
  double range, depth_margin, depth_margin_square, pose_margin, angle_margin, scan_pixel;
  int32_t hits, misses, support; int64_t age; int32_t slack, pixels;
  const tern_box* prior; int32_t prior_count; const tern_cylinder* prior_cylinders; int32_t prior_cylinder_count;
} tern_map_spec;
/* A camera's pose: its centre, and the quaternion (w, x, y, z) from its axes (right, down, ahead) to the world's. */
typedef struct { tern_vec3 position; double quaternion[4]; } tern_pose;
/* A depth image of yours: tern::DepthView. One of z16 and z32 is null. */
typedef struct {
  const uint16_t* z16; const float* z32;
  int32_t width, height, stride;
  double fx, fy, cx, cy, scale, min, max, no_return;
} tern_depth_view;
/* Beams of a scan of yours: tern::Beams. A range of +infinity: nothing came back; NaN: nothing is known. */
typedef struct {
  const tern_vec3* directions; const float* ranges; size_t count;
  double min, max;
} tern_beams;
/* clang-format on */
#endif

/* Size of tern_map in words of 64 bits. The core asserts that it suffices. */
#define TERN_MAP_WORDS 4

/* A map: an object of the library in memory of yours. It may hold anything before its first bind. Zero it if another
 * call can come before bind: that call then answers invalid_argument. Copies share the map. */
typedef struct {
  uint64_t opaque[TERN_MAP_WORDS];
} tern_map;

/* Common values: tern::map_spec(). Null does nothing. */
void tern_map_spec_init(tern_map_spec* spec, const tern_vec3* origin, double cell, tern_voxel dims, double radius);
/* Words of 64 bits that a map of this spec needs; 0 if the spec is null or out of range. */
size_t tern_map_words(const tern_map_spec* spec);
/* Binds the map to `words`, which are yours and must outlive it. ok, non_finite_input, invalid_argument, pixels_full or
 * prior_full. `field` receives the number of the field that is wrong; it may be null. */
uint8_t tern_map_bind(tern_map* map, const tern_map_spec* spec, uint64_t* words, size_t word_count, uint8_t* field);
/* Begins to enter a depth image; `t` in nanoseconds. The image must stay until the job is done. running, or the reason
 * why it is refused: pose_invalid, camera_invalid, out_of_map, pixels_full, clock_behind, non_finite_input,
 * invalid_argument. */
uint8_t tern_map_begin_frame(tern_map* map, const tern_depth_view* view, const tern_pose* pose, int64_t t);
/* Begins to enter a scan of `count` points, world frame, measured from `origin`. The points must stay until the job is
 * done. Answers as tern_map_begin_frame(). */
uint8_t tern_map_begin_scan(tern_map* map, const tern_vec3* points, size_t count, const tern_vec3* origin, int64_t t);
/* Begins to enter a scan of beams, which can also say that nothing came back, or that nothing is known. */
uint8_t tern_map_begin_beams(tern_map* map, const tern_beams* beams, const tern_vec3* origin, int64_t t);
/* Begins to move the window so that `center` comes near its middle. ok if it need not move, or running. */
uint8_t tern_map_follow(tern_map* map, const tern_vec3* center);
/* The clock of the frames was set: the next one may have any time. With a flight, call tern_flight_set_clock(). */
uint8_t tern_map_forget_time(tern_map* map);
/* Continues the job for at most `work` units. running: call it again. ok: no job is left. */
uint8_t tern_map_step(tern_map* map, uint32_t work);
/* 1 while the map has a job to be continued with tern_map_step(): it then accepts no other. Else 0. */
uint8_t tern_map_busy(const tern_map* map);
/* States, before take-off, that a ball is free: the voxels wholly inside it count as seen. */
uint8_t tern_map_assume_free(tern_map* map, const tern_vec3* center, double radius);
/* States, before take-off, where the vehicle stands: the column is free, and the ground below it is no higher than its
 * base. Then tern_flight_start() takes a start on that ground. */
uint8_t tern_map_assume_column(tern_map* map, const tern_cylinder* column);
/* Marks a box, an upright cylinder, or the voxels of points, as obstacles. */
uint8_t tern_map_mark_box(tern_map* map, const tern_box* world);
uint8_t tern_map_mark_cylinder(tern_map* map, const tern_cylinder* world);
uint8_t tern_map_mark_points(tern_map* map, const tern_vec3* world, size_t count);
/* Writes a view of the route grid (the unknown is free) or of the safe grid (the unknown is solid) to `grid`. It is
 * valid until the map slides; ask for it again after every slide. */
uint8_t tern_map_route(const tern_map* map, tern_grid* grid);
uint8_t tern_map_safe(const tern_map* map, tern_grid* grid);
/* Copies the route grid into `words`, which are yours: at least tern_grid_words(dims) words that outlive the grid.
 * Plans on the copy go on while frames are entered. Pass the same grid and words each time. `grid` may hold anything at
 * first, or zeros. ok, or invalid_argument: no map, an unfinished job, or too few words. */
uint8_t tern_map_snapshot(tern_map* map, tern_grid* grid, uint64_t* words, size_t word_count);
/* Begins the same copy as a job for tern_map_step: running. `grid` must stay where it is until the job is done. */
uint8_t tern_map_begin_snapshot(tern_map* map, tern_grid* grid, uint64_t* words, size_t word_count);
/* 1 if the voxel was seen free, else 0. */
uint8_t tern_map_seen(const tern_map* map, tern_voxel voxel);
/* Grows with every change of either grid. 0 for a map that is not bound. */
uint64_t tern_map_revision(const tern_map* map);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
