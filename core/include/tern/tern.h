/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Tern for C99. The same types as the C++ interface, under C names: in C++ they are aliases, in C they are declared
 * with the same layout, and tern_size_of() tells at run time what the library was compiled with. Units, frames, ranges
 * and ownership are as in the C++ headers, where every field is explained. Nothing here allocates, throws or blocks. */
#ifndef TERN_TERN_H
#define TERN_TERN_H

#include <stddef.h>
#include <stdint.h>

#include "tern/config.hpp"

/* Grows with every incompatible change of a type or function below. */
#define TERN_ABI 4

/* Storage for the two objects that C cannot see into; checked against the library at compile time of the core. */
#define TERN_GRID_WORDS 32
#define TERN_PLANNER_WORDS 160

#ifdef __cplusplus
#include "tern/tern.hpp"
typedef tern::Vec3 tern_vec3;
typedef tern::Voxel tern_voxel;
typedef tern::Box tern_box;
typedef tern::GridSpec tern_grid_spec;
typedef tern::State tern_state;
typedef tern::Limits tern_limits;
typedef tern::Budget tern_budget;
typedef tern::Halfspace tern_halfspace;
typedef tern::Fence tern_fence;
typedef tern::Request tern_request;
typedef tern::Segment tern_segment;
typedef tern::Trajectory tern_trajectory;
typedef tern::Sample tern_sample;
typedef tern::Yaw tern_yaw;
typedef tern::FlatState tern_flat_state;
typedef tern::StageReport tern_stage_report;
typedef tern::HighWater tern_high_water;
typedef tern::Report tern_report;
extern "C" {
#else
#include <stdbool.h>
/* clang-format off */
typedef struct { double x, y, z; } tern_vec3;
typedef struct { int32_t x, y, z; } tern_voxel;
typedef struct { tern_vec3 lower, upper; } tern_box;
typedef struct { tern_vec3 origin; double cell; tern_voxel dims; tern_box boundary; double radius; } tern_grid_spec;
typedef struct { tern_vec3 position, velocity, acceleration; } tern_state;
typedef struct {
  tern_vec3 v_max, a_max, v_min, a_min; /* a lower limit of 0 stands for the upper one's opposite */
  double v_horizontal, a_horizontal;    /* 0: none */
} tern_limits;
typedef struct { uint32_t expansions, sight_lines, planes, iterations; } tern_budget;
typedef struct { tern_vec3 normal; double offset; } tern_halfspace;
typedef struct { const tern_halfspace* planes; int32_t count; uint8_t kind; /* 0 keep-in, 1 keep-out */ } tern_fence;
typedef struct { double duration; tern_vec3 points[8]; int32_t polyhedron; } tern_segment;
typedef struct { int32_t count; tern_vec3 origin; tern_segment segments[TERN_MAX_SEGMENTS]; } tern_trajectory;
typedef struct {
  tern_state start, goal;
  tern_limits limits;
  tern_budget budget;
  uint8_t shortcut;   /* 0, the shortest chain: see tern::ShortcutMode; no other number */
  double time_weight; /* tern_request_init sets the default */
  const tern_fence* fences;
  int32_t fence_count;
  const tern_trajectory* previous; /* the plan that is being flown, or null; see tern::Request */
  double previous_time;
} tern_request;
typedef struct { tern_vec3 position, velocity, acceleration, jerk, snap; } tern_sample;
typedef struct { double cosine, sine, rate; } tern_yaw;
typedef struct {
  double thrust, attitude[3][3], quaternion[4];
  tern_vec3 body_rates;
  uint8_t singularity;
} tern_flat_state;
typedef struct { uint32_t work, bound; uint64_t ticks; } tern_stage_report;
typedef struct {
  int32_t nodes, open, jump_points, segments, planes, local_boxes, active, qp_iterations, qp_solves;
} tern_high_water;
typedef struct {
  uint8_t status, stage, field;
  bool raw_occupied, has_nearest_free, timing_known;
  uint8_t quality, optimiser;
  tern_vec3 nearest_free;
  tern_stage_report stages[7];
  tern_high_water high_water;
  int32_t fence; /* of the request's fences, the one that start or goal breaks; -1: none */
  int32_t half_spaces, half_spaces_redundant, detours;
  int32_t qp_variables, qp_inequalities, qp_active, qp_iterations;
  double kkt_residual;
} tern_report;
#endif

/* A grid view and a planner, each in place in the caller's storage. */
typedef struct { uint64_t opaque[TERN_GRID_WORDS]; } tern_grid;
typedef struct { uint64_t opaque[TERN_PLANNER_WORDS]; } tern_planner;
/* clang-format on */

/* What tern_size_of() can be asked for. */
typedef enum {
  TERN_SIZE_REQUEST = 0,
  TERN_SIZE_TRAJECTORY,
  TERN_SIZE_REPORT,
  TERN_SIZE_GRID_SPEC,
  TERN_SIZE_WORKSPACE, /* bytes that tern_planner_init needs */
  TERN_SIZE_WORKSPACE_ALIGNMENT
} tern_size;

/* The library's TERN_ABI, configuration hash and sizes: compare at start-up. */
int32_t tern_abi(void);
uint64_t tern_configuration_hash(void);
size_t tern_size_of(int32_t what); /* a tern_size; 0 for any other number */

/* The status' name ("ok", "no_path", ...) and one sentence on it. Every function below that answers uint8_t answers a
 * tern::Status; 0 is ok. Likewise the names of a report's stage and field. Any number has a name: "unknown" where it
 * is none of this version's. */
const char* tern_status_name(uint8_t status);
const char* tern_status_meaning(uint8_t status);
const char* tern_stage_name(uint8_t stage);
const char* tern_field_name(uint8_t field);

/* What tern_self_test() found wrong, one bit each, as in tern/self_test.hpp. */
typedef enum {
  TERN_FAULT_FLUSH_TO_ZERO = 1 << 0,    /* denormals are flushed: the program was linked with -ffast-math */
  TERN_FAULT_ROUNDING_MODE = 1 << 1,    /* not round-to-nearest-even */
  TERN_FAULT_CONTRACTION = 1 << 2,      /* a * b + c was fused: the core was compiled without -ffp-contract=off */
  TERN_FAULT_ARITHMETIC = 1 << 3,       /* NaN, infinity or sqrt are not IEEE 754's: -ffinite-math-only */
  TERN_FAULT_CONFIGURATION = 1 << 4,    /* the hash is not the library's */
  TERN_FAULT_RECIPROCAL_MATH = 1 << 5,  /* the core was compiled with -freciprocal-math */
  TERN_FAULT_NO_SIGNED_ZEROS = 1 << 6,  /* the core was compiled with -fno-signed-zeros */
  TERN_FAULT_ASSOCIATIVE_MATH = 1 << 7, /* the core was compiled with -fassociative-math */
  TERN_FAULT_SINGLE_PRECISION_CONSTANT = 1 << 8 /* core or caller: -fsingle-precision-constant */
} tern_fault;

/* Flush-to-zero, rounding mode, compiler flags, arithmetic, and `hash` against the library's configuration. `faults`,
 * a sum of tern_fault, may be null. */
uint8_t tern_self_test(uint64_t hash, uint32_t* faults);

/* Grid: words of storage (0 where the dimensions do not fit), then bind, mark, inflate. `words` stays the caller's and
 * must outlive the grid. A tern_grid may hold anything at its first bind; where another call can come before it, zero
 * the tern_grid, and that call answers kInvalidArgument. A bind that is refused leaves grid and words as they were. */
size_t tern_grid_words(tern_voxel dims);
uint8_t tern_grid_bind(tern_grid* grid, const tern_grid_spec* spec, uint64_t* words, size_t word_count);
uint8_t tern_grid_mark_box(tern_grid* grid, const tern_box* world);
uint8_t tern_grid_clear_box(tern_grid* grid, const tern_box* world);
uint8_t tern_grid_mark_points(tern_grid* grid, const tern_vec3* world, size_t count, size_t* inside);
uint8_t tern_grid_inflate(tern_grid* grid);

/* What tern_configuration_hash() answers where this header is compiled with the library's capacities. Whole numbers
 * alone: the last two are the bits of the core's floating-point constants. */
static inline uint64_t tern_header_hash(void) {
  const uint64_t values[] = {TERN_MAX_CELLS,        TERN_MAX_DIMENSION,     TERN_MAX_NODES,     TERN_MAX_OPEN,
                             TERN_MAX_JUMP_POINTS,  TERN_MAX_SEGMENTS,      TERN_MAX_PLANES,    TERN_MAX_LOCAL_BOXES,
                             TERN_MAX_ACTIVE,       TERN_MAX_QP_ITERATIONS, TERN_MAX_QP_SOLVES, TERN_MAX_FENCES,
                             TERN_MAX_FENCE_PLANES, TERN_MAX_FENCE_WORDS,   0x112e0be826d695u,  0x1999999999999au};
  uint64_t hash = 0xCBF29CE484222325u;
  for (size_t i = 0; i < sizeof values / sizeof *values; ++i) hash = (hash ^ values[i]) * 0x100000001B3u;
  return hash;
}

/* Planner over `memory` (tern_size_of(TERN_SIZE_WORKSPACE) bytes, any alignment and content), the caller's. A caller
 * that was compiled with other capacities than the library is answered kInvalidArgument, here and by every plan (field
 * kConfiguration). Languages that do not read this header call the first with tern_configuration_hash(). */
uint8_t tern_planner_init_for(tern_planner* planner, void* memory, size_t bytes, uint64_t configuration);
static inline uint8_t tern_planner_init(tern_planner* planner, void* memory, size_t bytes) {
  return tern_planner_init_for(planner, memory, bytes, tern_header_hash());
}
uint8_t tern_planner_set_clock(tern_planner* planner, uint64_t (*clock)(void* context), void* context);
/* A request with the default budget (no limit but the bounds) and time weight, and everything else zero. */
void tern_request_init(tern_request* request);
/* The six half-spaces of a box, for a fence that is one. */
void tern_box_halfspaces(const tern_box* box, tern_halfspace planes[6]);
/* One call, or begin / step / finish; see tern::Planner. `trajectory` is untouched unless the answer is 0. */
uint8_t tern_plan(tern_planner* planner, const tern_grid* grid, const tern_request* request,
                  tern_trajectory* trajectory, tern_report* report);
uint8_t tern_plan_begin(tern_planner* planner, const tern_grid* grid, const tern_request* request);
uint8_t tern_plan_step(tern_planner* planner, uint32_t work);
uint8_t tern_plan_finish(tern_planner* planner, tern_trajectory* trajectory, tern_report* report);

/* The trajectory's duration in seconds, and its state at t seconds; total in all inputs, zeros for null. */
double tern_duration(const tern_trajectory* trajectory);
void tern_evaluate(const tern_trajectory* trajectory, double t, tern_sample* sample);
/* Thrust, attitude and body rates that fly a sample with that yaw; see tern/flatness.hpp. Total: null for a sample is
 * zeros, for a yaw yaw 0. */
void tern_flat(const tern_sample* sample, const tern_yaw* yaw, tern_flat_state* state);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
