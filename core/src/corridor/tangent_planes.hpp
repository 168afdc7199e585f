// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CORRIDOR_TANGENT_PLANES_HPP
#define TERN_CORRIDOR_TANGENT_PLANES_HPP

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/grow_scratch.hpp"
#include "corridor/separation.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "ellipsoid/ellipsoid_metric.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"

namespace tern {

/// A sieve in progress. Plain data; all 0 at first.
struct Sieve {
  int next;  ///< the box to look at next
  int kept;  ///< boxes so far that no half-space cuts off
};

constexpr int kSieved = 64;
/// Moves the boxes that no half-space cuts off by `radius` to the front, in their order. A piece of work looks at
/// kSieved boxes. kDone: sieve.kept is their number.
Progress keep_uncut(Sieve& sieve, const Polyhedron& polyhedron, double radius, LocalBox* boxes, int count,
                    Work& work) noexcept;

/// A pass over the obstacles in progress. Plain data; needs no initialisation before tangents_begin.
struct TangentPass {
  EllipsoidMetric metric;
  int listed;          ///< obstacles that are listed as remaining
  int count;           ///< obstacles that remain, once all are listed
  int met;             ///< place, among the remaining obstacles, of the one that `contact` belongs to; -1: none yet
  BoxContact contact;  ///< of obstacle `met`
  int looks;           ///< contacts computed for the next half-space
};

/// Step (2) of the paper's Section 3.3.1: adds half-spaces to `out` until each obstacle is beyond one of them by the
/// radius. The obstacles are those that `out` does not cut off yet. The next half-space is made for the obstacle that
/// the growing ellipsoid meets first; if it meets two at once, for the one with the lower index. It also settles every
/// other obstacle that it cuts off. Each half-space settles at least one obstacle.
void tangents_begin(TangentPass& pass, const EllipsoidMetric& metric) noexcept;

constexpr int kListed = 128;
/// A piece of work lists kListed obstacles, or computes a contact. After the last contact that a half-space needs, it
/// also makes the half-space. kDone, or kFailed with `status` kCorridorBlocked or kPlanesFull.
Progress tangents_advance(TangentPass& pass, const Obstacles& obstacles, const SegmentMargin& segment,
                          GrowScratch& scratch, Polyhedron& out, Work& work, Status& status) noexcept;

}  // namespace tern

#endif
