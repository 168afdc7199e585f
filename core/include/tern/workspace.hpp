// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner's memory. Its size is a constant that follows from the capacities of config.hpp.
#ifndef TERN_WORKSPACE_HPP
#define TERN_WORKSPACE_HPP

#include <stddef.h>

#include "tern/config.hpp"

namespace tern {

/// Alignment that the planner uses, in bytes. The memory that you give it needs no alignment: the planner begins at the
/// first aligned byte, and kWorkspaceBytes allows for that.
constexpr size_t kWorkspaceAlignment = 64;

namespace workspace {

// What each part of the workspace takes, in bytes. These are upper bounds, about a tenth above the sizes of the core's
// structures, which no public header shows. The core asserts at compile time that the bounds hold. They are not part of
// the interface: use kWorkspaceBytes.
constexpr size_t kNodes = kMaxNodes, kHeap = kMaxOpen, kCells = static_cast<size_t>(kMaxCells);
constexpr size_t kJumps = kMaxJumpPoints, kSegments = kMaxSegments, kPlanes = kMaxPlanes;
constexpr size_t kBoxes = kMaxLocalBoxes, kActive = kMaxActive, kVias = kMaxVias;

constexpr size_t larger(size_t a, size_t b) {
  return a < b ? b : a;
}

constexpr size_t kDimension = static_cast<size_t>(kMaxDimension);

/// The jump stops of the search: for each of six directions, one bit a voxel, and how far they are known.
constexpr size_t kJumpStops = kCells * 6 / 8 + kCells / 16;
/// The search: nodes with their hash slots, the open list, a dominance record for each 64 voxels, and the jump stops.
constexpr size_t kSearch = kNodes * 48 + kHeap * 24 + kDimension * 320 + kCells / 8 + kCells / 256 + kJumpStops + 16384;
/// The flood of the voxels that the start can reach: a layer, and a queue of its rows.
constexpr size_t kReach = static_cast<size_t>(kMaxWorldWords) * 12 + static_cast<size_t>(kMaxWorldWords) / 8 + 4096;
/// Fences: as they were given, as the stages use them, and the blocked layer of a grid with fences.
constexpr size_t kFencePlanes = kMaxFencePlanes;
constexpr size_t kFences =
    kFencePlanes * (160 + 16 * kFencePlanes) + kMaxFences * 256 + static_cast<size_t>(kMaxWorldWords) * 8 + 1024;
/// Tracks, as they were given, and their pieces; keep-outs for a while as tracks.
constexpr size_t kThings = static_cast<size_t>(kMaxTracks) + kMaxFences;
constexpr size_t kTracks = kThings * 160 + kMaxFences * 32 + static_cast<size_t>(kMaxTrackPieces) * 200 + 3072;
/// The flood in time: its layers, and the cells of a way.
constexpr size_t kFlood = static_cast<size_t>(kMaxFloodWords) * 8 + 4096;
/// The corridor: the solid boxes around one segment, and the scratch memory to merge and measure them.
constexpr size_t kCorridor = kBoxes * 88 + 4096;
/// The trajectory: points and planes of the quadratic programme, and the dense factor of its active set.
constexpr size_t kTrajectory = kSegments * (17000 + kPlanes * 112) + kActive * (kSegments * 96 + kActive * 4 + 128) +
                               static_cast<size_t>(kMaxSeparations) * 1340 + kThings * 8 + 8192;
/// The check: for each segment, normals along which keep-outs are cut off.
constexpr size_t kCheck = kSegments * kMaxFences * 272 + kFencePlanes * 256 + 8192;
/// The results, which outlive the stages that made them: the path and its current leg, vias, corridor, trajectory, the
/// stops of both ends and the previous plan.
constexpr size_t kResults = (kJumps + kSegments) * 24 * 2 + kVias * 400 + kSegments * (kPlanes * 36 + 1248) + 6400;
/// What plans around things that move begin from: the plan as if nothing moved with its corridor, and two more.
constexpr size_t kAround = kSegments * (kPlanes * 32 + 56 + 3 * 208 + 24 + 32) + 512;

}  // namespace workspace

/// Bytes that a planner needs: 132 kB for the profile tiny, 369 kB for fmu, 5.1 MB for mcu, 119 MB for companion.
/// Search, corridor and trajectory share one part of it, one after the other. If the core's assertion fails for
/// capacities of your own, define TERN_WORKSPACE_BYTES to a larger number, for the core and for your program.
#ifdef TERN_WORKSPACE_BYTES
constexpr size_t kWorkspaceBytes = TERN_WORKSPACE_BYTES;
#else
constexpr size_t kWorkspaceBytes =
    (workspace::larger(
         workspace::larger(workspace::kSearch, workspace::larger(workspace::kReach, workspace::kFlood)),
         workspace::larger(workspace::larger(workspace::kCorridor, workspace::kCheck), workspace::kTrajectory)) +
     workspace::kResults + workspace::kAround + workspace::kFences + workspace::kTracks + 2 * kWorkspaceAlignment - 1) /
    kWorkspaceAlignment * kWorkspaceAlignment;
#endif

/// Memory of the right size. Make it static, or place it in a linker section or an arena: it is too large for a stack.
struct alignas(kWorkspaceAlignment) Workspace {
  unsigned char bytes[kWorkspaceBytes];
};

}  // namespace tern

#endif
