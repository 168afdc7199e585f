// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every capacity of the core: what it limits, what it costs, and what happens beyond it. The core allocates nothing.
// Input that does not fit gets a status, never a wrong result.
//
// Choose a profile, or leave the default:
// - TERN_PROFILE_TINY: for tests. Every capacity is easy to exceed.
// - TERN_PROFILE_FMU: an autopilot's microcontroller. Workspace and grid take 400 KB together.
// - TERN_PROFILE_MCU: a Cortex-M7 with 16 MB of memory.
// - TERN_PROFILE_COMPANION: a Jetson-class computer. The default.
//
// To change single capacities, write a header that defines some of the macros below, and define TERN_USER_CONFIG to its
// name in quotes. This file includes that header first. Diagnostics::high_water shows how much of each capacity a plan
// used.
//
// Compile the core and everything that includes its headers with the same definitions. The library refuses a program
// with other capacities than its own (Field::kConfiguration). The macros are for C and C++, the constants for C++.
#ifndef TERN_CONFIG_HPP
#define TERN_CONFIG_HPP

#ifdef TERN_USER_CONFIG
#include TERN_USER_CONFIG
#endif

#if defined(TERN_PROFILE_TINY)
#define TERN_DEFAULT(tiny, fmu, mcu, companion) tiny
#elif defined(TERN_PROFILE_FMU)
#define TERN_DEFAULT(tiny, fmu, mcu, companion) fmu
#elif defined(TERN_PROFILE_MCU)
#define TERN_DEFAULT(tiny, fmu, mcu, companion) mcu
#else
#define TERN_DEFAULT(tiny, fmu, mcu, companion) companion
#endif

/// Voxels in one grid. Each takes two bits of the grid's storage and nearly one byte of the planner's workspace, so
/// this capacity costs the most memory. Beyond it: kInvalidArgument from Grid::bind, field kDimensions.
#ifndef TERN_MAX_CELLS
#define TERN_MAX_CELLS TERN_DEFAULT(32 * 1024, 96 * 1024, 2 * 1024 * 1024, 64 * 1024 * 1024)
#endif

/// Voxels along one axis, 2048 at most. This capacity bounds how far the search jumps in one go, and keeps the cost of
/// any path inside 64-bit fixed point. Beyond it: kInvalidArgument from Grid::bind, field kDimensions.
#ifndef TERN_MAX_DIMENSION
#define TERN_MAX_DIMENSION TERN_DEFAULT(64, 128, 512, 2048)
#endif

/// Jump points that one search may generate, 40 bytes each. The six maps of the paper need some tens of thousands with
/// voxels of 0.05 m. Beyond it: kNodesFull.
#ifndef TERN_MAX_NODES
#define TERN_MAX_NODES TERN_DEFAULT(96, 2048, 32 * 1024, 512 * 1024)
#endif

/// Entries of the search's open list, 24 bytes each. Beyond it: kOpenFull.
#ifndef TERN_MAX_OPEN
#define TERN_MAX_OPEN TERN_DEFAULT(48, 1536, 32 * 1024, 512 * 1024)
#endif

/// Points of a jump-point path before it is shortened, 24 bytes each. Beyond it: kJumpPointsFull.
#ifndef TERN_MAX_JUMP_POINTS
#define TERN_MAX_JUMP_POINTS TERN_DEFAULT(16, 64, 256, 2048)
#endif

/// Segments of a trajectory, polyhedra of a corridor, legs of a path. A Trajectory takes 208 bytes for each. Beyond it:
/// kSegmentsFull.
#ifndef TERN_MAX_SEGMENTS
#define TERN_MAX_SEGMENTS TERN_DEFAULT(4, 10, 32, 48)
#endif

/// Half-spaces of one polyhedron, 32 bytes each. Six of them are the faces of the box that the polyhedron is grown in.
/// If they do not suffice, the planner tries a smaller box, then a shorter segment. Beyond that: kPlanesFull.
#ifndef TERN_MAX_PLANES
#define TERN_MAX_PLANES TERN_DEFAULT(10, 16, 24, 40)
#endif

/// Solid boxes into which the obstacle voxels around one segment are merged, 88 bytes each. If they do not suffice, the
/// planner tries a smaller box around the segment, then a shorter segment. Beyond that: kObstaclesFull.
#ifndef TERN_MAX_LOCAL_BOXES
#define TERN_MAX_LOCAL_BOXES TERN_DEFAULT(24, 1024, 1024, 8192)
#endif

/// Constraints that may be active at once in the quadratic programme. The factor of the active set is dense and takes
/// about (12 * segments + this) * this * 8 bytes. Beyond it the plan falls back to stop-and-go, with Report::optimiser
/// kWorkingSetFull.
#ifndef TERN_MAX_ACTIVE
#define TERN_MAX_ACTIVE TERN_DEFAULT(12, 64, 192, 192)
#endif

/// Iterations of one quadratic programme. They cost no memory; they bound the time. Beyond it, the programme counts as
/// unsolved. If none is solved, the plan falls back to stop-and-go, with Report::optimiser kIterationLimit.
#ifndef TERN_MAX_QP_ITERATIONS
#define TERN_MAX_QP_ITERATIONS TERN_DEFAULT(40, 800, 800, 1500)
#endif

/// Quadratic programmes that may be solved for one corridor, while the planner looks for better durations. They cost no
/// memory; they bound the time. After the last one, the answer is the best plan so far, or stop-and-go if there is
/// none.
#ifndef TERN_MAX_QP_SOLVES
#define TERN_MAX_QP_SOLVES TERN_DEFAULT(6, 48, 48, 48)
#endif

/// Geofences of one request. Each takes 256 bytes for each segment, from memory that the stages share. Beyond it:
/// kFencesFull.
#ifndef TERN_MAX_FENCES
#define TERN_MAX_FENCES TERN_DEFAULT(2, 4, 16, 16)
#endif

/// Vias of one request. Each takes about 300 bytes of the workspace and 16 of a Report. A way through vias needs a
/// segment for each, and one more. Beyond it: kViasFull.
#ifndef TERN_MAX_VIAS
#define TERN_MAX_VIAS TERN_DEFAULT(2, 4, 16, 16)
#endif

/// Half-spaces of all fences of one request together, 96 at most. The workspace takes 160 + 16 * this bytes for each,
/// most of them for the corners of keep-out fences. Beyond it: kFencePlanesFull.
#ifndef TERN_MAX_FENCE_PLANES
#define TERN_MAX_FENCE_PLANES TERN_DEFAULT(14, 16, 48, 64)
#endif

/// Words of the blocked layer that a plan makes for itself, 8 bytes each. It makes one for a request with fences, and
/// for the flood from the start if no path leads to the goal. A word holds 64 voxels of a row along x, and each row
/// begins with a new word. 1 is enough if no request has fences or GoalMode::kNearest, and nobody reads
/// Report::reachable. Beyond it: kWorldFull.
#ifndef TERN_MAX_WORLD_WORDS
#define TERN_MAX_WORLD_WORDS TERN_DEFAULT(1024, 1536, 48 * 1024, 2 * 1024 * 1024)
#endif

/// Tracks of one request: things that move. Each takes 160 bytes of the workspace, and 152 of a PlanRecord. Beyond it:
/// kTracksFull.
#ifndef TERN_MAX_TRACKS
#define TERN_MAX_TRACKS TERN_DEFAULT(2, 8, 32, 256)
#endif

/// Pieces of all tracks of one request together, 200 bytes each. A track that keeps its velocity has none, and another
/// vehicle's plan one for each segment. Beyond it: kTrackPiecesFull.
#ifndef TERN_MAX_TRACK_PIECES
#define TERN_MAX_TRACK_PIECES TERN_DEFAULT(3, 8, 64, 512)
#endif

/// Other members of a fleet that a Fleet can know. Each takes 800 bytes of it, 208 for each segment and 13 for each of
/// them. Beyond it: kNeighboursFull from Fleet::add.
#ifndef TERN_MAX_NEIGHBOURS
#define TERN_MAX_NEIGHBOURS TERN_DEFAULT(2, 8, 16, 128)
#endif

/// Planes that keep the segments of a plan off things that move, one for each segment and track that come near each
/// other, and one more for each further piece of the track. Each takes 1.3 KB of the workspace. Beyond it: the plan is
/// not led around them, and fails with kSeparationsFull if it cannot wait either.
#ifndef TERN_MAX_SEPARATIONS
#define TERN_MAX_SEPARATIONS TERN_DEFAULT(4, 12, 96, 192)
#endif

/// Words of all layers of the flood in time, which looks for a way around things that move; 64 cells each. They share
/// memory with the search. If they do not suffice, cells become larger. Beyond that: no such way is looked for, and the
/// plan fails with kFloodFull if nothing else helps.
#ifndef TERN_MAX_FLOOD_WORDS
#define TERN_MAX_FLOOD_WORDS TERN_DEFAULT(256, 24 * 1024, 256 * 1024, 1024 * 1024)
#endif

/// Pixels of the images that a rolling map takes (MapSpec::pixels), 4 bytes each in the map's words. Beyond it:
/// kPixelsFull.
#ifndef TERN_MAX_PIXELS
#define TERN_MAX_PIXELS TERN_DEFAULT(4096, 160 * 120, 320 * 240, 2 * 1024 * 1024)
#endif

/// Boxes of a rolling map's prior (MapSpec::prior), and as many cylinders (prior_cylinders). They cost no memory of the
/// map, but time in every slide. Beyond it: kPriorFull.
#ifndef TERN_MAX_PRIOR_BOXES
#define TERN_MAX_PRIOR_BOXES TERN_DEFAULT(4, 64, 256, 4096)
#endif

/// Pieces of a yaw plan's spline, 90 bytes each in a YawPlanner and 8 in a YawPlan. Beyond it: longer pieces, never
/// shorter than a tenth of a second.
#ifndef TERN_MAX_YAW_PIECES
#define TERN_MAX_YAW_PIECES TERN_DEFAULT(16, 64, 128, 256)
#endif

#ifdef __cplusplus

#include <stddef.h>
#include <stdint.h>

namespace tern {

constexpr int64_t kMaxCells = TERN_MAX_CELLS;
constexpr int32_t kMaxDimension = TERN_MAX_DIMENSION;
constexpr int kMaxNodes = TERN_MAX_NODES;
constexpr int kMaxOpen = TERN_MAX_OPEN;
constexpr int kMaxJumpPoints = TERN_MAX_JUMP_POINTS;
constexpr int kMaxSegments = TERN_MAX_SEGMENTS;
constexpr int kMaxWaypoints = kMaxSegments + 1;
constexpr int kMaxPlanes = TERN_MAX_PLANES;
constexpr int kMaxLocalBoxes = TERN_MAX_LOCAL_BOXES;
constexpr int kMaxActive = TERN_MAX_ACTIVE;
constexpr int kMaxQpIterations = TERN_MAX_QP_ITERATIONS;
constexpr int kMaxQpSolves = TERN_MAX_QP_SOLVES;
constexpr int kMaxFences = TERN_MAX_FENCES;
constexpr int kMaxFencePlanes = TERN_MAX_FENCE_PLANES;
constexpr int32_t kMaxVias = TERN_MAX_VIAS;
constexpr int32_t kMaxTracks = TERN_MAX_TRACKS;
constexpr int32_t kMaxTrackPieces = TERN_MAX_TRACK_PIECES;
constexpr int32_t kMaxNeighbours = TERN_MAX_NEIGHBOURS;
constexpr int64_t kMaxWorldWords = TERN_MAX_WORLD_WORDS;
constexpr int kMaxSeparations = TERN_MAX_SEPARATIONS;
constexpr int32_t kMaxFloodWords = TERN_MAX_FLOOD_WORDS;
constexpr int32_t kMaxPixels = TERN_MAX_PIXELS;
constexpr int32_t kMaxPriorBoxes = TERN_MAX_PRIOR_BOXES;
constexpr int32_t kMaxYawPieces = TERN_MAX_YAW_PIECES;

/// Coordinates that differ by less than this share of a voxel count as equal. A box whose faces are off the lattice
/// only by rounding then takes no additional voxel. 1e-9 of a voxel of 0.1 m is 0.1 nm.
constexpr double kLatticeTolerance = 1e-9;

/// Every line of sight keeps this share of a voxel, on each axis, from every voxel that is not free. Polyhedra then
/// contain their lines with room to spare, and two neighbours share a ball around their common point.
constexpr double kSightMargin = 0.05;

static_assert(kMaxCells <= int64_t{1} << 27 && kMaxDimension <= 2048, "a path cost is 64-bit fixed point");
static_assert(kMaxPlanes >= 8, "six box faces and two obstacles at least");
static_assert(kMaxSegments >= 2 && kMaxSegments <= 1024, "segment indices are small");
static_assert(kMaxFences >= 1 && kMaxFencePlanes >= 6 && kMaxFencePlanes <= 96 && kMaxWorldWords >= 1,
              "a fence that is a box; facets of fences live on the stack");
static_assert(kMaxVias >= 1 && kMaxVias <= 1024, "sizes of reports are small");
static_assert(kMaxTracks >= 1 && kMaxTracks <= 1024 && kMaxTrackPieces >= 1 && kMaxTrackPieces <= 65536,
              "indices and bounds of work are small");
static_assert(kMaxNeighbours >= 1 && kMaxNeighbours <= 1024, "a state fits in 16 bits");
static_assert(kMaxSeparations >= 1 && kMaxSeparations <= 4096, "points of a programme are 8 for each");
static_assert(kMaxFloodWords >= 64 && kMaxFloodWords <= (1 << 26), "sizes of layers are 32 bits");
static_assert(kMaxPixels >= 64 && kMaxPixels <= (1 << 26) && kMaxPriorBoxes >= 1, "sizes of images are 32 bits");
static_assert(kMaxYawPieces >= 8 && kMaxYawPieces <= 4096, "a start, an end and something between");
static_assert(kMaxNodes < (1 << 30) && kMaxOpen < (1 << 30), "node indices are 32 bits");

}  // namespace tern

#endif  // __cplusplus

#endif
