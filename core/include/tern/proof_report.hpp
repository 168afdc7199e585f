// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far a proof came, and what ended it. Plans, brakes, flights and your own trajectories are judged alike.
#ifndef TERN_PROOF_REPORT_HPP
#define TERN_PROOF_REPORT_HPP

#include <stdint.h>

#include "tern/fence.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"
#include "tern/via.hpp"

namespace tern {

/// How far a proof came, and what ended it: the first thing, in the order of the trajectory. An index is -1, and a
/// voxel has coordinates -1, if the finding is not about one.
struct ProofReport {
  /// Seconds since the beginning of the trajectory. From the proof's beginning to here, the trajectory is proven.
  double until = 0.0;
  /// What ended the proof there. kNone: the whole trajectory is proven, and nothing below but `work` has a value.
  Finding finding = Finding::kNone;
  /// Segment of the trajectory. For kJoint, the later of the two.
  int32_t segment = -1;
  /// For kFence, and if Proof::begin() refuses a fence: its index in the list of fences.
  int32_t fence = kNoFence;
  /// For kTrack, and if TrackProof::begin() refuses a track: its index in the list of tracks. -1: none.
  int32_t track = -1;
  /// For kVia: its index in Request::vias.
  int32_t via = kNoVia;
  /// 0 position, 1 velocity, 2 acceleration, 3 jerk; 4 for kBodyRate.
  int32_t derivative = -1;
  /// 0 x, 1 y, 2 z; 3 the horizontal norm; of an acceleration also 4 the thrust, 5 the tilt.
  int32_t axis = -1;
  /// For kObstacle: the voxel that is too near.
  Voxel voxel{-1, -1, -1};
  /// By how much more than the proof grants: metres, or m/s, m/s^2 or m/s^3 for a derivative; m/s^2 of horizontal
  /// thrust for the tilt, rad/s for a body rate. >= 0. The worst that was seen on the way to the finding. 0 for
  /// kMalformed and kPieces, and if no point that was looked at exceeds the grant.
  double excess = 0.0;
  /// Units of work done so far (tern/work.hpp).
  uint32_t work = 0;
};

}  // namespace tern

#endif
