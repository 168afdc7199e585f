// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences in proofs: tells whether the hull of a few points respects them. Reads the caller's own half-spaces.
#ifndef TERN_PROVE_FENCES_HPP
#define TERN_PROVE_FENCES_HPP

#include <cstdint>

#include "base/work.hpp"
#include "prove/cut_off.hpp"
#include "prove/solid.hpp"
#include "tern/config.hpp"
#include "tern/corridor.hpp"
#include "tern/fence.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The fences of a request, as the caller gave them: world frame, normals of any length. The fences point into
/// `planes`, so they may not move.
struct AskedWorld {
  std::int32_t count;
  Fence fence[kMaxFences];
  Halfspace planes[kMaxFencePlanes];
};

/// Copies the caller's fences, which find_fence_fault() has accepted. False if they are too many.
bool copy_asked(const Fence* list, std::int32_t count, AskedWorld& asked) noexcept;

/// The rule by which a hull must respect fences.
struct FenceRule {
  Vec3 frame;        ///< of the points, in the world, metres
  double distance;   ///< from keep-outs, metres
  double tolerance;  ///< by which points may lie outside a keep-in, metres, >= 0
};

/// True only if the hull of the points lies in the keep-in, or a face, an edge or a corner of the keep-out cuts it off
/// by the distance. For a keep-out, the answer may be false although the hull keeps the distance, but hardly ever if
/// the points are close together.
bool fence_clear(const Fence& fence, const FenceRule& rule, const Vec3* points, int count, Work& work) noexcept;

/// Metres by which a point breaks the rule: outside the keep-in, or too near to the keep-out, as far as its faces tell.
double fence_excess(const Fence& fence, const FenceRule& rule, const Vec3& point) noexcept;

/// Memory for one keep-out at a time, relative to the centre of the box around the boundary.
struct FenceScratch {
  Solid<DoubleDouble> exact;
  Solid<double> quick;  ///< the same, rounded
};

/// Normals that one segment may have as hints: one for each eighth of it and each fence. The planner's hints fit by
/// their number (planner/hints.hpp), so none is ever left out.
constexpr int kMaxFenceHints = 8 * kMaxFences;

/// Normals along which keep-outs may be cut off from a segment. The offsets do not matter.
struct FenceHints {
  std::int32_t count;
  Halfspace planes[kMaxFenceHints];
};

/// The planner's hints for the proof of its plan, and memory to use them. The proof does not depend on them.
struct PlanHints {
  const Corridor* corridor;         ///< may be null, empty, or wrong
  std::int32_t hinted;              ///< the number of segments, from the first on, that have hints for fences
  std::int32_t solid;               ///< the planner's next solid for the segment behind them
  FenceHints fences[kMaxSegments];  ///< the hints besides the corridor's
  FenceScratch scratch;
};

/// A hull that keeps a distance. Local frame, metres.
struct Apart {
  const Vec3* points;
  int count;
  double distance;
};

/// True only if fence `index`, a keep-out, is cut off from the hull by the distance, along the normal of a hint or of
/// one of its own faces. The keep-out may have any shape, however thin or pointed. Only the part of it within the
/// radius of the boundary and of all keep-ins counts.
bool keep_out_cut_off(const Grid& grid, const Fence* fences, int count, int index, const Hints& hints,
                      const Apart& hull, FenceScratch& scratch, Work& work) noexcept;

/// Corners are looked for if a keep-out has no more faces than this.
constexpr int kCornerFaces = 12;
/// Operations of fence_clear() for a face against eight points, for an edge, and for a corner: few planes that touch an
/// edge or a corner leave the first point behind them.
constexpr Operations kFaceOperations = 16 * ops::kDot;
constexpr Operations kEdgeOperations = 5 * ops::kDot;
constexpr Operations kCornerOperations = 12 * ops::kDot;
/// Operations of keep_out_cut_off(): without normals, and for each normal in doubles and in twice their precision. A
/// normal takes six pivots or so.
constexpr Operations kKeepOutOperations = 60 * ops::kPiece;
constexpr Operations kQuickOperations = 25 * ops::kPiece;
constexpr Operations kExactOperations = 330 * ops::kPiece;
/// The most operations of both for kMaxFences fences: keep_out_cut_off() may be called with the hints of both kinds.
constexpr Operations kAskedOperations =
    kMaxFences * (ops::kPiece + kFaceOperations * kMaxFencePlanes +
                  kEdgeOperations * (Operations{kMaxFencePlanes} * kMaxFencePlanes / 2) +
                  kCornerOperations * kCornerFaces * kCornerFaces * kCornerFaces / 6 +
                  2 * (kKeepOutOperations +
                       (kQuickOperations + kExactOperations) * (kMaxPlanes + kMaxFenceHints + kMaxFencePlanes)));

}  // namespace tern

#endif
