// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_WORKSPACE_HPP
#define TERN_WORKSPACE_HPP

#include <stddef.h>

#include "tern/config.hpp"

namespace tern {

/// Alignment of the planner's memory; a block that is not aligned is served from its first aligned byte.
constexpr size_t kWorkspaceAlignment = 64;

namespace workspace {

// What each part takes, from the capacities: an upper bound, a tenth or so above the truth, that this header can state
// without showing the core's own structures. The core asserts at compile time that it holds.
constexpr size_t kNodes = kMaxNodes, kHeap = kMaxOpen, kCells = static_cast<size_t>(kMaxCells);
constexpr size_t kJumps = kMaxJumpPoints, kSegments = kMaxSegments, kPlanes = kMaxPlanes;
constexpr size_t kBoxes = kMaxLocalBoxes, kActive = kMaxActive;

constexpr size_t larger(size_t a, size_t b) {
  return a < b ? b : a;
}

constexpr size_t kDimension = static_cast<size_t>(kMaxDimension);

/// Nodes with their hash slots, the open list's entries and bins, and a dominance record for each 64 voxels.
constexpr size_t kSearch = kNodes * 48 + kHeap * 24 + kDimension * 320 + kCells / 8 + kCells / 256 + 16384;
/// A bit a voxel for the stops of scans in six directions, three bytes for each 64 voxels for how far scans have
/// walked, and what the map was; from plan to plan.
constexpr size_t kScans = kCells * 6 / 8 + kCells / 16 + kCells / 128 + 1024;
/// Fences as they are and as the stages use them, the blocked layer of a grid with fences, the normals tried for one of
/// them.
constexpr size_t kFencePlanes = kMaxFencePlanes;
constexpr size_t kFences =
    kFencePlanes * (160 + 16 * kFencePlanes) + kMaxFences * 256 + static_cast<size_t>(kMaxFenceWords) * 8 + 1024;
/// Solid boxes with what merging and measuring them takes.
constexpr size_t kCorridor = kBoxes * 88 + 4096;
/// The quadratic programme's points and planes, and the dense factor of its working set.
constexpr size_t kTrajectory =
    kSegments * (9600 + kPlanes * 112) + kActive * (kSegments * 96 + kActive * 4 + 128) + 8192;
/// Path, corridor and trajectory, which outlive the stages that made them.
constexpr size_t kResults =
    (kJumps + kSegments) * 24 + kSegments * 448 + (kSegments + 32) * (kPlanes * 32 + 400) + 1024;

}  // namespace workspace

/// Bytes that a planner needs, a constant of the configuration: 101 KB for tiny, 5.0 MB for mcu, 119 MB for companion,
/// nearly all of it the search's. TERN_WORKSPACE_BYTES overrides the estimate where unusual capacities defeat it.
#ifdef TERN_WORKSPACE_BYTES
constexpr size_t kWorkspaceBytes = TERN_WORKSPACE_BYTES;
#else
constexpr size_t kWorkspaceBytes =
    (workspace::larger(workspace::kSearch, workspace::larger(workspace::kCorridor, workspace::kTrajectory)) +
     workspace::kScans + workspace::kResults + workspace::kFences + 2 * kWorkspaceAlignment - 1) /
    kWorkspaceAlignment * kWorkspaceAlignment;
#endif

/// A block of the right size for a static, a linker section or an arena.
struct alignas(kWorkspaceAlignment) Workspace {
  unsigned char bytes[kWorkspaceBytes];
};

}  // namespace tern

#endif
