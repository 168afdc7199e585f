// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every capacity of the core, with its reason and its price. Nothing in the core allocates: what
// does not fit is answered by the status that the capacity names, never by a wrong result.
//
// Three profiles ship: TERN_PROFILE_TINY (tests: every overflow is cheap to reach),
// TERN_PROFILE_MCU (a Cortex-M7 with 16 MB) and TERN_PROFILE_COMPANION (a Jetson-class computer,
// the default). To change single values, define TERN_USER_CONFIG to a header of your own that
// defines some of the macros below; it is included first and wins. Compile the core and whatever
// includes it with the same definitions: self_test() and the configuration hash catch a mismatch. The macros are
// readable from C; the constants below them are for C++.
#ifndef TERN_CONFIG_HPP
#define TERN_CONFIG_HPP

#ifdef TERN_USER_CONFIG
#include TERN_USER_CONFIG
#endif

#if defined(TERN_PROFILE_TINY)
#define TERN_DEFAULT(tiny, mcu, companion) tiny
#elif defined(TERN_PROFILE_MCU)
#define TERN_DEFAULT(tiny, mcu, companion) mcu
#else
#define TERN_DEFAULT(tiny, mcu, companion) companion
#endif

/// Voxels in one grid. One bit a layer: 33.5 M voxels are 4 MB a layer, in the caller's storage.
/// Beyond it: Status::kInvalidArgument from Grid::bind.
#ifndef TERN_MAX_CELLS
#define TERN_MAX_CELLS TERN_DEFAULT(32 * 1024, 2 * 1024 * 1024, 64 * 1024 * 1024)
#endif

/// Voxels along one axis. Bounds a scan and keeps a path's cost far inside 64-bit fixed point.
#ifndef TERN_MAX_DIMENSION
#define TERN_MAX_DIMENSION TERN_DEFAULT(64, 512, 2048)
#endif

/// Jump points a search may generate, 48 bytes each with their hash slots. The six maps of the
/// paper at 0.05 m need some tens of thousands. Beyond it: Status::kNodesFull.
#ifndef TERN_MAX_NODES
#define TERN_MAX_NODES TERN_DEFAULT(96, 32 * 1024, 512 * 1024)
#endif

/// Entries of the search's open list, 24 bytes each. Beyond it: Status::kOpenFull.
#ifndef TERN_MAX_OPEN
#define TERN_MAX_OPEN TERN_DEFAULT(48, 32 * 1024, 512 * 1024)
#endif

/// Turning points of a raw jump-point path, 24 bytes each. Beyond it: Status::kJumpPointsFull.
#ifndef TERN_MAX_JUMP_POINTS
#define TERN_MAX_JUMP_POINTS TERN_DEFAULT(16, 256, 2048)
#endif

/// Segments of a trajectory, each with its polyhedron. Beyond it: Status::kSegmentsFull.
#ifndef TERN_MAX_SEGMENTS
#define TERN_MAX_SEGMENTS TERN_DEFAULT(4, 32, 48)
#endif

/// Half-spaces of one polyhedron, its six box faces included, 32 bytes each. Beyond it the
/// polyhedron's box shrinks; where the smallest does not do: Status::kPlanesFull.
#ifndef TERN_MAX_PLANES
#define TERN_MAX_PLANES TERN_DEFAULT(10, 24, 40)
#endif

/// Solid boxes that the obstacles around one segment merge into, 88 bytes each with their scratch. Beyond it the
/// polyhedron's box shrinks; where the smallest does not do: Status::kObstaclesFull.
#ifndef TERN_MAX_LOCAL_BOXES
#define TERN_MAX_LOCAL_BOXES TERN_DEFAULT(24, 1024, 8192)
#endif

/// Constraints active at once in the quadratic programme. The working set's factor is dense and
/// thin: (12 * segments + this) * this * 8 bytes or so. Beyond it: Status::kWorkingSetFull.
#ifndef TERN_MAX_ACTIVE
#define TERN_MAX_ACTIVE TERN_DEFAULT(12, 192, 192)
#endif

/// Iterations of one quadratic programme: the bound that its worst-case time is measured at.
/// Beyond it: Status::kIterationLimit.
#ifndef TERN_MAX_QP_ITERATIONS
#define TERN_MAX_QP_ITERATIONS TERN_DEFAULT(40, 800, 1500)
#endif

/// Quadratic programmes solved for one plan: first solution, stretches and refinements together.
#ifndef TERN_MAX_QP_SOLVES
#define TERN_MAX_QP_SOLVES TERN_DEFAULT(6, 24, 24)
#endif

/// Geofences of one request. Beyond it: Status::kFencesFull.
#ifndef TERN_MAX_FENCES
#define TERN_MAX_FENCES TERN_DEFAULT(2, 16, 16)
#endif

/// Half-spaces of all fences of one request together, some 230 bytes each with the corners of keep-outs. Beyond it:
/// Status::kFencePlanesFull.
#ifndef TERN_MAX_FENCE_PLANES
#define TERN_MAX_FENCE_PLANES TERN_DEFAULT(14, 48, 64)
#endif

/// Words of the blocked layer of a grid that is planned on with fences, 8 bytes each: a row of voxels takes whole words
/// of 64. Beyond it: Status::kFenceLayerFull. 1 is enough where no request has fences.
#ifndef TERN_MAX_FENCE_WORDS
#define TERN_MAX_FENCE_WORDS TERN_DEFAULT(1024, 48 * 1024, 2 * 1024 * 1024)
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
constexpr int64_t kMaxFenceWords = TERN_MAX_FENCE_WORDS;

/// Distances that differ by less than this part of a voxel count as equal, so that boxes that lie on
/// the lattice but for rounding do not take a further voxel. 1e-9 of a 0.1 m voxel is 0.1 nm.
constexpr double kLatticeTolerance = 1e-9;

/// Every line of sight keeps this part of a voxel (max norm) from every voxel that is not free, so
/// that polyhedra around it hold it with a margin and neighbours share a ball around a waypoint.
constexpr double kSightMargin = 0.05;

static_assert(kMaxCells <= int64_t{1} << 27 && kMaxDimension <= 2048, "a path cost is 64-bit fixed point");
static_assert(kMaxPlanes >= 8, "six box faces and two obstacles at least");
static_assert(kMaxSegments >= 2 && kMaxSegments <= 1024, "segment indices are small");
static_assert(kMaxFences >= 1 && kMaxFencePlanes >= 6 && kMaxFencePlanes <= 96 && kMaxFenceWords >= 1,
              "a fence that is a box; facets of fences live on the stack");
static_assert(kMaxNodes < (1 << 30) && kMaxOpen < (1 << 30), "node indices are 32 bits");

}  // namespace tern

#endif  // __cplusplus

#endif
