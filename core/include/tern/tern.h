/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Tern for C99. The types are those of the C++ interface under C names. In C++ they are aliases; in C they are declared
 * here with the same layout. The C++ headers, named below, explain every field: units, frames, ranges, ownership.
 *
 * In order: check tern_abi(), tern_size_of() and tern_self_test(). Bind a grid to storage of yours, mark obstacles,
 * inflate it. Initialise a planner over a workspace of yours. Fill in a request, call tern_plan(), and fly the
 * trajectory with tern_evaluate(). docs/examples/replan_once_c.c is a program.
 *
 * Answers: a function that returns uint8_t returns a tern_status; 0 is ok. A null pointer where none is allowed
 * answers invalid_argument and changes nothing. Nothing here allocates, throws, blocks or reads a clock of its own. */
#ifndef TERN_TERN_H
#define TERN_TERN_H

#include <stddef.h>
#include <stdint.h>

#include "tern/config.hpp"

/* Version of this interface. It grows with every incompatible change of a type or function below. Compare it with
 * tern_abi(). */
#define TERN_ABI 13

/* Size of tern_grid and tern_planner in words of 64 bits. The core asserts at compile time that they suffice. */
#define TERN_GRID_WORDS 32
#define TERN_PLANNER_WORDS 160

#ifdef __cplusplus
#include "tern/tern.hpp"
typedef tern::Vec3 tern_vec3;
typedef tern::Voxel tern_voxel;
typedef tern::Box tern_box;
typedef tern::GridSpec tern_grid_spec;
typedef tern::Cylinder tern_cylinder;
typedef tern::State tern_state;
typedef tern::Limits tern_limits;
typedef tern::Budget tern_budget;
typedef tern::Halfspace tern_halfspace;
typedef tern::Fence tern_fence;
typedef tern::Via tern_via;
typedef tern::Request tern_request;
typedef tern::Segment tern_segment;
typedef tern::Trajectory tern_trajectory;
typedef tern::Sample tern_sample;
typedef tern::Yaw tern_yaw;
typedef tern::FlatState tern_flat_state;
typedef tern::StageReport tern_stage_report;
typedef tern::ProofReport tern_proof_report;
typedef tern::TrackPiece tern_track_piece;
typedef tern::Track tern_track;
typedef tern::HighWater tern_high_water;
typedef tern::ViaPassage tern_via_passage;
typedef tern::Diagnostics tern_diagnostics;
typedef tern::Report tern_report;
extern "C" {
#else
#include <stdbool.h>
/* clang-format off */
/* Points, voxels, boxes: tern/vec3.hpp. Metres; a box has lower <= upper on every axis. */
typedef struct { double x, y, z; } tern_vec3;
typedef struct { int32_t x, y, z; } tern_voxel;
typedef struct { tern_vec3 lower, upper; } tern_box;
/* Where a grid lies, how fine it is, and the robot's radius: tern/grid.hpp. World frame, metres. */
typedef struct {
  tern_vec3 origin; double cell; tern_voxel dims; tern_box boundary; double radius, tracking_margin;
} tern_grid_spec;
/* An upright cylinder; `base` is the centre of its lower face: tern::Cylinder. World frame, metres. */
typedef struct { tern_vec3 base; double radius, height; } tern_cylinder;
/* Start or goal: tern/request.hpp. World frame; m, m/s, m/s^2, m/s^3. */
typedef struct { tern_vec3 position, velocity, acceleration, jerk; } tern_state;
/* Limits per axis and of the horizontal norm: tern/request.hpp. m/s, m/s^2 and m/s^3. */
typedef struct {
  tern_vec3 v_max, a_max, v_min, a_min; /* upper ones > 0, lower ones < 0; a lower one of 0 means minus the upper one */
  double v_horizontal, a_horizontal;    /* > 0; 0 means none */
  tern_vec3 j_max;                      /* m/s^3, > 0 in both directions; an axis of 0 has no limit */
  double j_horizontal;                  /* m/s^3, > 0; 0 means none */
  double thrust_max, thrust_min;        /* of |a + (0, 0, gravity)|, m/s^2, > 0; 0 means none */
  double tilt_tangent, rate_max;        /* tangent of the largest tilt; rad/s, roll and pitch; > 0; 0 means none */
} tern_limits;
/* Units of work that a plan may spend in each stage, about a thousand instructions each: tern/request.hpp. UINT32_MAX
 * means no limit but the stage's own bound. */
typedef struct { uint32_t search, shortcut, corridor, trajectory, tracks; } tern_budget;
/* All points p with normal . p <= offset: tern/halfspace.hpp. */
typedef struct { tern_vec3 normal; double offset; } tern_halfspace;
/* A geofence: tern/fence.hpp. `planes` points to `count` half-spaces that the caller owns; world frame. */
typedef struct {
  const tern_halfspace* planes;
  int32_t count;
  uint8_t kind;        /* 0 keep-in, 1 keep-out */
  int64_t from, until; /* ns, of a fence for a while; equal: it always holds */
  double clock_error;  /* s */
} tern_fence;
/* A point to pass on the way: tern/via.hpp. World frame; m and m/s. `velocity` counts only with has_velocity. */
typedef struct {
  tern_vec3 position;
  double tolerance; /* m, >= 0: how near the plan comes */
  bool stop, has_velocity;
  tern_vec3 velocity;
  double dwell; /* s, 0 .. 3600: how long the plan rests there; only with stop */
} tern_via;
/* A Bezier segment, and a plan: tern/trajectory.hpp. Seconds; metres relative to `origin`, a point in the world.
 * `polyhedron` is -1 for a segment that no corridor was made for. `begin` is when the plan begins, in nanoseconds of a
 * clock of yours. */
typedef struct { double duration; tern_vec3 points[8]; int32_t polyhedron; } tern_segment;
typedef struct {
  int64_t begin; int32_t count; tern_vec3 origin; tern_segment segments[TERN_MAX_SEGMENTS];
} tern_trajectory;
/* A piece of a moving thing's curve, and a thing that moves: tern/track.hpp. World frame; seconds, metres, and
 * nanoseconds of the clock of tern_request.begin. If every member is zero, the track is a point that never moves and
 * never ends. */
typedef struct { double duration; tern_vec3 points[8]; /* relative to the track's position */ } tern_track_piece;
typedef struct {
  int64_t measured, until;
  tern_vec3 position, velocity;
  const tern_track_piece* pieces; /* yours; null for a thing that keeps its velocity */
  int32_t piece_count;
  uint32_t id, kind; /* for your own use */
  uint8_t shape;     /* tern::TrackShape: 0 ball, 1 upright cylinder, 2 box */
  uint8_t end;       /* tern::TrackEnd, after `until`: 0 goes on, 1 gone, 2 stays, 3 its error grows by `reach` */
  double radius;     /* of a ball or a cylinder */
  tern_vec3 half;    /* of a box; z of a cylinder */
  double error, error_speed, error_growth; /* m, m/s, m/s^2: the error s seconds later is e + es s + eg s^2 / 2 */
  double reach;      /* m/s; 0: nothing is known */
} tern_track;
/* A query: tern/request.hpp. Fill it in after tern_request_init(). You own it and everything that it points to. */
typedef struct {
  tern_state start, goal;
  tern_limits limits;
  tern_budget budget;
  int64_t begin;            /* when the plan begins: nanoseconds of a clock of yours, which the plan carries */
  uint8_t search;           /* tern::SearchMode: 0 fast, 1 optimal; any other number is refused */
  uint8_t goal_mode;        /* tern::GoalMode: 0 exact, 1 as near as possible; any other number is refused */
  double time_weight;       /* duration against smoothness, 0.001 .. 1e6 */
  const tern_fence* fences; /* geofences, or null with fence_count 0 */
  int32_t fence_count;
  const tern_via* vias; /* points to pass on the way, in order, or null with via_count 0 */
  int32_t via_count;
  const tern_track* tracks; /* things that move, or null with track_count 0 */
  int32_t track_count;
  double rest_clear; /* s: for how long the plan's end must stay clear of the tracks */
  /* For replanning: the plan that is being flown, or null. `start` must be its state at previous_time, as tern_evaluate
   * gives it. It may be the trajectory that the new plan is written to. See tern::Request. */
  const tern_trajectory* previous;
  double previous_time; /* seconds, >= 0 */
} tern_request;
/* A trajectory's state at one time: tern/trajectory.hpp. World frame; m, m/s, m/s^2, m/s^3, m/s^4. */
typedef struct { tern_vec3 position, velocity, acceleration, jerk, snap; } tern_sample;
/* Where the nose points, and the setpoint of a controller: tern/flatness.hpp. */
typedef struct { double cosine, sine, rate; } tern_yaw;
typedef struct {
  /* Thrust over mass, m/s^2; rotation from body to world, row by row; the same as (w, x, y, z). */
  double thrust, attitude[3][3], quaternion[4];
  tern_vec3 body_rates; /* rad/s, body frame */
  uint8_t singularity;  /* tern::Singularity: 0 none, 1 free fall, 2 heading, 3 not finite */
} tern_flat_state;
/* How far a proof came, and what ended it: tern/proof_report.hpp. -1 if an index or a voxel has no value. */
typedef struct {
  double until;    /* seconds since the beginning of the trajectory */
  uint8_t finding; /* TERN_FINDING_..., tern_finding_name() */
  int32_t segment, fence, track, via;
  int32_t derivative, axis; /* 0 position .. 3 jerk; 0 x, 1 y, 2 z, 3 the horizontal norm */
  tern_voxel voxel;
  double excess; /* by how much more than the proof grants: m, m/s, m/s^2 or m/s^3 */
  uint32_t work;
} tern_proof_report;
/* When a plan passes a via, in seconds, and how far from it, in metres: tern/report.hpp. */
typedef struct { double time, distance; } tern_via_passage;
/* The work of one stage, the highest use of each capacity, and all diagnostics of a plan: tern/diagnostics.hpp. */
typedef struct { uint64_t work, bound, ticks; } tern_stage_report;
typedef struct {
  int32_t nodes, open, jump_points, segments, planes, local_boxes, active, qp_iterations, qp_solves, separations,
      flood_words;
} tern_high_water;
typedef struct {
  /* request, search, shortcut, corridor, times, trajectory, check, world, detour, previous, stop_first, reach, tracks */
  tern_stage_report stages[13];
  bool timing_known; /* the ticks were measured */
  tern_high_water high_water;
  int32_t detours;     /* 0 none, 1 detour, 2 stop first, 3 previous plan */
  int32_t seed;        /* of a plan around things that move: 1 the plan as if nothing moved, 2 and more a flood */
  double search_bound; /* cost of the path over a lower bound of the least cost; 0 without a path */
  uint8_t search_used; /* 0 none, 1 the guided search, 2 the optimal search */
} tern_diagnostics;
/* The answer to a call of the planner: tern/report.hpp. */
typedef struct {
  /* The answer, the stage where it arose, and the field that is wrong: tern_status_name() and so on. */
  uint8_t status, stage, field;
  /* True if, in this order: the occupied start or goal is itself inside an obstacle; nearest_free has a value;
   * reachable has a value. */
  bool raw_occupied, has_nearest_free, has_reachable;
  /* Quality: 0 none, 1 hover, 2 stop-and-go, 3 optimised, 4 previous plan. Optimiser: its final status. Goal_missed:
   * why the plan ends at `reachable` instead of the goal; 0 if it does not. */
  uint8_t quality, optimiser, goal_missed;
  double entered;              /* s: the plan begins at this time on the trajectory; 0 but for a previous plan */
  tern_vec3 nearest_free;      /* world frame: centre of the free voxel nearest to an occupied start or goal */
  tern_vec3 reachable;         /* world frame: the point nearest to the goal that a path leads to */
  int32_t fence; /* index of the fence that is wrong, or that start, goal or via breaks; -1: none */
  int32_t via;   /* index of the via that is wrong or that the plan could not be led to; -1: none */
  int32_t track; /* index of the track that is wrong, or that the first plan, or the start, is not clear of; -1: none */
  double conflict;         /* s: when the first plan meets it; at the goal, if that is covered */
  double goal_free;        /* s: from when on the plan could rest at a goal that is covered; infinity */
  double rest_clear_until; /* s: until when the plan's end is clear of all tracks; infinity */
  double waits;            /* s at rest before it sets out, for things that move */
  tern_via_passage vias[TERN_MAX_VIAS];
  tern_proof_report check; /* only if status or optimiser is check_failed */
  double finer_cell; /* m, only for TERN_*_TOO_NARROW: a voxel's edge that would do; 0 if none is known */
  tern_diagnostics diagnostics;
} tern_report;
#endif

/* A grid and a planner. Both are objects of the library in your memory; their contents are private. Do not copy a
 * planner. A tern_grid may be copied once it is bound: it is a view, and all copies share the storage. */
typedef struct { uint64_t opaque[TERN_GRID_WORDS]; } tern_grid;
typedef struct { uint64_t opaque[TERN_PLANNER_WORDS]; } tern_planner;
/* clang-format on */

/* Every answer: tern::Status, tern/status.hpp, which says when each arises. A function that answers with a uint8_t
 * returns one of these. */
typedef enum {
  /* Success, or work left. */
  TERN_OK = 0,
  TERN_RUNNING = 1,
  /* The request or the call is wrong: correct it. */
  TERN_NON_FINITE_INPUT = 10,
  TERN_INVALID_ARGUMENT = 11,
  TERN_LIMITS_INVALID = 12,
  TERN_OUT_OF_MAP = 13,
  TERN_START_EXCEEDS_LIMITS = 14,
  TERN_GOAL_EXCEEDS_LIMITS = 15,
  TERN_VIA_EXCEEDS_LIMITS = 16,
  TERN_FENCE_EMPTY = 17,
  TERN_POSE_INVALID = 18,
  TERN_CAMERA_INVALID = 19,
  TERN_RECORD_DAMAGED = 20,
  TERN_RECORD_VERSION = 21,
  TERN_CLOCK_BEHIND = 22,
  /* The request is right, but the world has no answer to it. */
  TERN_START_OCCUPIED = 30,
  TERN_GOAL_OCCUPIED = 31,
  TERN_NO_PATH = 32,
  TERN_MAP_CHANGED = 33,
  TERN_CORRIDOR_BLOCKED = 34,
  TERN_NO_TRAJECTORY = 35,
  TERN_START_FENCED = 36,
  TERN_GOAL_FENCED = 37,
  TERN_VIA_OCCUPIED = 38,
  TERN_VIA_FENCED = 39,
  TERN_START_TOO_NARROW = 40,
  TERN_GOAL_TOO_NARROW = 41,
  TERN_VIA_TOO_NARROW = 42,
  TERN_START_IN_CONTACT = 43,
  TERN_GOAL_COVERED = 44,
  TERN_NO_CLEAR_TIME = 45,
  /* A capacity ran out. */
  TERN_NODES_FULL = 50,
  TERN_OPEN_FULL = 51,
  TERN_JUMP_POINTS_FULL = 52,
  TERN_SEGMENTS_FULL = 53,
  TERN_PLANES_FULL = 54,
  TERN_OBSTACLES_FULL = 55,
  TERN_WORKING_SET_FULL = 56,
  TERN_ITERATION_LIMIT = 57,
  TERN_FENCES_FULL = 58,
  TERN_FENCE_PLANES_FULL = 59,
  TERN_WORLD_FULL = 60,
  TERN_VIAS_FULL = 61,
  TERN_NEIGHBOURS_FULL = 62,
  TERN_PIXELS_FULL = 63,
  TERN_PRIOR_FULL = 64,
  TERN_RECORD_FULL = 65,
  TERN_TRACKS_FULL = 66,
  TERN_TRACK_PIECES_FULL = 67,
  TERN_SEPARATIONS_FULL = 68,
  TERN_FLOOD_FULL = 69,
  /* The solver or the machine did not hold up. */
  TERN_INFEASIBLE = 70,
  TERN_NUMERICAL = 71,
  TERN_CHECK_FAILED = 72,
  TERN_SELF_TEST_FAILED = 73,
  /* The request's budget ran out. */
  TERN_BUDGET_SEARCH = 90,
  TERN_BUDGET_SHORTCUT = 91,
  TERN_BUDGET_CORRIDOR = 92,
  TERN_BUDGET_OPTIMISE = 93,
  TERN_BUDGET_TRACKS = 94
} tern_status;

/* The sizes that tern_size_of() knows, in bytes. */
typedef enum {
  TERN_SIZE_REQUEST = 0,        /* sizeof(tern_request) */
  TERN_SIZE_TRAJECTORY,         /* sizeof(tern_trajectory) */
  TERN_SIZE_REPORT,             /* sizeof(tern_report) */
  TERN_SIZE_GRID_SPEC,          /* sizeof(tern_grid_spec) */
  TERN_SIZE_WORKSPACE,          /* what tern_planner_init() needs */
  TERN_SIZE_WORKSPACE_ALIGNMENT /* the planner aligns the workspace itself */
} tern_size;

/* The library's TERN_ABI. Use the library only if it equals yours. */
int32_t tern_abi(void);
/* A hash of the capacities that the library was compiled with. tern_header_hash() is that of your program. */
uint64_t tern_configuration_hash(void);
/* A size in the library; `what` is a tern_size. Returns 0 for any other number. Compare it with your sizeof. */
size_t tern_size_of(int32_t what);

/* Names and meanings of the numbers in a report: constant strings, never null, nothing to free. A number that this
 * version does not know is "unknown". */
/* "ok", "no_path", ... */
const char* tern_status_name(uint8_t status);
/* One line of English: what the status means and, in many cases, what to do. */
const char* tern_status_meaning(uint8_t status);
/* "request", "search", "shortcut", ... */
const char* tern_stage_name(uint8_t stage);
/* "start position", "v_max", ... */
const char* tern_field_name(uint8_t field);
/* "obstacle", "velocity", ...: what the check refuses a plan for. */
const char* tern_finding_name(uint8_t finding);

/* What tern_self_test() found wrong, one bit each, as in tern/self_test.hpp. Remove the flag that is named. */
typedef enum {
  TERN_FAULT_FLUSH_TO_ZERO = 1 << 0,    /* denormals are flushed to zero: linked with -ffast-math */
  TERN_FAULT_ROUNDING_MODE = 1 << 1,    /* not round-to-nearest-even */
  TERN_FAULT_CONTRACTION = 1 << 2,      /* a * b + c was fused: the core was compiled without -ffp-contract=off */
  TERN_FAULT_ARITHMETIC = 1 << 3,       /* NaN, infinity or sqrt are not IEEE 754's: -ffinite-math-only */
  TERN_FAULT_CONFIGURATION = 1 << 4,    /* the hash is not the library's */
  TERN_FAULT_RECIPROCAL_MATH = 1 << 5,  /* the core was compiled with -freciprocal-math */
  TERN_FAULT_NO_SIGNED_ZEROS = 1 << 6,  /* the core was compiled with -fno-signed-zeros */
  TERN_FAULT_ASSOCIATIVE_MATH = 1 << 7, /* the core was compiled with -fassociative-math */
  TERN_FAULT_SINGLE_PRECISION_CONSTANT = 1 << 8 /* core or caller: -fsingle-precision-constant */
} tern_fault;

/* Tests the floating-point arithmetic of the calling thread, and compares `hash` with the library's configuration: pass
 * tern_header_hash(). Run it at start-up in every thread that plans. ok or self_test_failed; `faults` gets the sum of
 * tern_fault bits and may be null. */
uint8_t tern_self_test(uint64_t hash, uint32_t* faults);

/* The grid: tern::Grid, tern/grid.hpp. A tern_grid may hold anything before its first bind. If another call can come
 * first, zero the tern_grid: that call then answers invalid_argument. */
/* Words of 64 bits that a grid of these dimensions needs as storage. 0 if a dimension is out of range. */
size_t tern_grid_words(tern_voxel dims);
/* Binds the grid to `words` and clears it. You own `words`: at least tern_grid_words(spec->dims) words with any
 * content, which must outlive the grid. ok, non_finite_input or invalid_argument. A refused bind leaves grid and words
 * as they were. */
uint8_t tern_grid_bind(tern_grid* grid, const tern_grid_spec* spec, uint64_t* words, size_t word_count);
/* Marks each voxel that the box meets as an obstacle. World frame, metres; parts outside the grid are ignored. ok,
 * non_finite_input or invalid_argument. */
uint8_t tern_grid_mark_box(tern_grid* grid, const tern_box* world);
/* Marks each voxel that the cylinder meets as an obstacle. Frame, unit and answers as for tern_grid_mark_box(). */
uint8_t tern_grid_mark_cylinder(tern_grid* grid, const tern_cylinder* world);
/* Clears the voxels that tern_grid_mark_box() would mark. Answers as tern_grid_mark_box(). */
uint8_t tern_grid_clear_box(tern_grid* grid, const tern_box* world);
/* Marks the voxel of each of `count` points, world frame, metres. Points outside the grid are skipped. `inside` gets
 * the number of the others and may be null. `world` may be null if count is 0. ok, non_finite_input (nothing is marked)
 * or invalid_argument. */
uint8_t tern_grid_mark_points(tern_grid* grid, const tern_vec3* world, size_t count, size_t* inside);
/* Marks in a coarse grid what a fine one closes: tern::Grid::mark_grid(). The coarse grid's cell is four times the fine
 * one's, and the fine grid, which is inflated, begins at a corner of a coarse cell. ok or invalid_argument; `field`,
 * which may be null, gets the tern_field that does not fit. */
uint8_t tern_grid_mark_grid(tern_grid* coarse, const tern_grid* fine, uint8_t* field);
/* Makes the grid ready to be planned on. Call it once after any number of binds, marks and clears. ok, or
 * invalid_argument for a grid that is not bound. */
uint8_t tern_grid_inflate(tern_grid* grid);

/* A hash of the capacities that your program is compiled with. It equals tern_configuration_hash() if they are the same
 * as the library's. It uses integers only: the last two represent the core's floating-point constants. */
static inline uint64_t tern_header_hash(void) {
  const uint64_t values[] = {
      TERN_MAX_CELLS,        TERN_MAX_DIMENSION,   TERN_MAX_NODES,        TERN_MAX_OPEN,        TERN_MAX_JUMP_POINTS,
      TERN_MAX_SEGMENTS,     TERN_MAX_PLANES,      TERN_MAX_LOCAL_BOXES,  TERN_MAX_ACTIVE,      TERN_MAX_QP_ITERATIONS,
      TERN_MAX_QP_SOLVES,    TERN_MAX_FENCES,      TERN_MAX_FENCE_PLANES, TERN_MAX_VIAS,        TERN_MAX_TRACKS,
      TERN_MAX_TRACK_PIECES, TERN_MAX_NEIGHBOURS,  TERN_MAX_SEPARATIONS,  TERN_MAX_FLOOD_WORDS, TERN_MAX_WORLD_WORDS,
      TERN_MAX_PIXELS,       TERN_MAX_PRIOR_BOXES, TERN_MAX_YAW_PIECES,   0x112e0be826d695u,    0x1999999999999au};
  uint64_t hash = 0xCBF29CE484222325u;
  for (size_t i = 0; i < sizeof values / sizeof *values; ++i) hash = (hash ^ values[i]) * 0x100000001B3u;
  return hash;
}

/* The planner: tern::Planner, tern/planner.hpp. Initialise a tern_planner before any other call with it. It is not
 * thread-safe; two planners over two workspaces are independent. */
/* Makes a planner over `memory`: `bytes` bytes, at least tern_size_of(TERN_SIZE_WORKSPACE), with any alignment and
 * content. The memory is yours and must outlive the planner; nobody else may write to it. `configuration` is the hash
 * of the capacities that the caller was compiled with. ok, or invalid_argument for memory that is null or too small, or
 * for another configuration than the library's; every plan then answers the same. This function is for languages that
 * cannot use this header; pass tern_configuration_hash() there. */
uint8_t tern_planner_init_for(tern_planner* planner, void* memory, size_t bytes, uint64_t configuration);
/* Makes a planner for a program with the capacities of this header. C programs call this function. */
static inline uint8_t tern_planner_init(tern_planner* planner, void* memory, size_t bytes) {
  return tern_planner_init_for(planner, memory, bytes, tern_header_hash());
}
/* The clock for the ticks of a report, any monotonic counter; null for none. It is called with `context`, which is
 * yours. No plan depends on it. */
uint8_t tern_planner_set_clock(tern_planner* planner, uint64_t (*clock)(void* context), void* context);
/* Sets the default budget (no limit but the bounds of the stages) and time weight, and everything else to zero. Null is
 * allowed and does nothing. */
void tern_request_init(tern_request* request);
/* Another vehicle's trajectory as a track: tern::track_of, tern/track.hpp. `pieces` has room for `room` pieces and must
 * stay as long as the track is used. ok, invalid_argument or track_pieces_full. */
uint8_t tern_track_of(const tern_trajectory* trajectory, double radius, tern_track_piece* pieces, int32_t room,
                      tern_track* track);
/* Classes of things, for tern_track_of_class(): tern::TrackClass, docs/tracks.md#classes. */
enum {
  TERN_TRACK_PERSON = 0,
  TERN_TRACK_CYCLIST = 1,
  TERN_TRACK_CAR = 2,
  TERN_TRACK_TRUCK = 3,
  TERN_TRACK_BIRD = 4,
  TERN_TRACK_DRONE = 5,
  TERN_TRACK_AIRCRAFT = 6
};
/* A thing of a class (a TERN_TRACK_... constant), still to be placed: tern::track_of_class, tern/track_class.hpp. Sets
 * its shape, its size and what it may do, and all else to zero. ok or invalid_argument. */
uint8_t tern_track_of_class(uint8_t kind, tern_track* track);
/* Writes the six half-spaces of a box, for a fence that is a box. In the frame of the box. Null does nothing. */
void tern_box_halfspaces(const tern_box* box, tern_halfspace planes[6]);
/* Plans in one call. The grid must be inflated. With ok, `trajectory` is the plan; with any other answer, it is
 * unchanged. `report` is always filled in, unless a pointer is null. */
uint8_t tern_plan(tern_planner* planner, const tern_grid* grid, const tern_request* request,
                  tern_trajectory* trajectory, tern_report* report);
/* Begins a plan in slices. It has the same bits as that of tern_plan(). Answers running, or why it refuses the request.
 * The grid must stay at its address, bound and unchanged, until tern_plan_finish(). You may change the request at
 * once. */
uint8_t tern_plan_begin(tern_planner* planner, const tern_grid* grid, const tern_request* request);
/* Continues for `work` units, about a thousand instructions each; tern/planner.hpp says more. running: call it again.
 * Any other answer is that of the plan: call tern_plan_finish(). map_changed if the grid has changed since
 * tern_plan_begin(). */
uint8_t tern_plan_step(tern_planner* planner, uint32_t work);
/* Ends the plan and fills `report`. With ok, `trajectory` is the plan; with any other answer, it is unchanged. If you
 * call it too early, it abandons the plan and answers invalid_argument, field "call order". */
uint8_t tern_plan_finish(tern_planner* planner, tern_trajectory* trajectory, tern_report* report);
/* Finds a path alone, in one call: tern::Planner::route(). With ok, tern_path() returns it. `report` is always filled
 * in, unless a pointer is null. */
uint8_t tern_route(tern_planner* planner, const tern_grid* grid, const tern_request* request, tern_report* report);
/* Begins a route in slices; duties and answers are those of tern_plan_begin(). tern_plan_step() continues it. */
uint8_t tern_route_begin(tern_planner* planner, const tern_grid* grid, const tern_request* request);
/* Ends the route and fills `report`. If you call it too early, or after tern_plan_begin(), it abandons what was begun
 * and answers invalid_argument, field "call order". */
uint8_t tern_route_finish(tern_planner* planner, tern_report* report);
/* Copies the first `room` waypoints of the last route's or plan's path, metres, relative to the grid's origin. Returns
 * how many the path has: at most TERN_MAX_SEGMENTS + 1, and 0 if there is none. `points` may be null if room is 0. Call
 * it before the planner's next plan or route. */
int32_t tern_path(const tern_planner* planner, tern_vec3* points, int32_t room);

/* The trajectory's duration in seconds. 0 for null. */
double tern_duration(const tern_trajectory* trajectory);
/* The time on the trajectory when its clock shows `now`, seconds; negative before its beginning. 0 for null. */
double tern_time_on(const tern_trajectory* trajectory, int64_t now);
/* The trajectory's state at t seconds after its beginning, world frame. Before the beginning and for NaN: the state at
 * the beginning. Past the end: the goal's position at rest. Zeros for a null trajectory. */
void tern_evaluate(const tern_trajectory* trajectory, double t, tern_sample* sample);
/* Thrust, attitude and body rates that fly a sample with that yaw; see tern/flatness.hpp. Every input has an answer. A
 * null sample counts as all zero, a null yaw as yaw 0. */
void tern_flat(const tern_sample* sample, const tern_yaw* yaw, tern_flat_state* state);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
