// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contract C4: every plan that leaves the planner as kOk was proven here, by code that shares nothing with the stages
// that made it. It reads the raw obstacle layer, the request and the control points. The corridor only tells along
// which normals obstacles may be cut off: a wrong one cannot make a false proof.
#ifndef TERN_PROVE_CHECK_STAGE_HPP
#define TERN_PROVE_CHECK_STAGE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "prove/fences.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/proof.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"
#include "tern/via.hpp"

namespace tern {

/// Pieces of work of one check: pieces of each segment's position of its three derivatives and of its body rates, and
/// the joints.
constexpr std::uint32_t kCheckBound = kMaxSegments * (5u * (kProofPieces + 1) + 1u) + 1u;
/// The same of the proof against tracks: a stretch for each segment and what lies between, of each track, and for each
/// piece of a track; the plan's rest may be proven twice.
constexpr std::uint64_t track_bound(std::int32_t count) noexcept {
  return 2 * (static_cast<std::uint64_t>(count) * (kMaxSegments + 8) + kMaxTrackPieces) * (kTrackPieces + 2);
}
/// The same of fences for a while: each may begin and end within a plan.
constexpr std::uint64_t kWindowBound = 2 * std::uint64_t{kMaxSegments + 2 * kMaxFences + 8} * (kTrackPieces + 2);
/// The most operations of one of its pieces: three tubes, or the next stretch with its own.
constexpr Operations kTrackOperations = 8 * ops::kCurve + 2 * ops::kPiece;
/// The most operations of one of them.
Operations check_piece_operations(const GridSpec& spec) noexcept;

/// What the request asked of the plan, as the caller gave it. World frame.
struct CheckQuery {
  State start;  ///< with the jerk that the plan was made to begin with
  State goal;
  Limits limits;
  double entered = 0.0;  ///< when the plan enters the trajectory, s since its beginning; what lies before is not flown
  const AskedWorld* world = nullptr;  ///< null: nothing but voxels
  const Via* vias = nullptr;
  const std::int32_t* joints = nullptr;  ///< for each via, the segment that begins where the plan passes it, or the
                                         ///< number of segments
  std::int32_t via_count = 0;
  const Track* tracks = nullptr;
  std::int32_t track_count = 0;
  double rest = 0.0;  ///< s: for how long the plan's end must be clear of the tracks
};

enum class CheckPhase : std::uint8_t { kBegin, kCurve, kJoints, kRest };

/// A check of a whole plan, or of a part of one. Plain data; needs no initialisation before check_begin.
struct CheckStage {
  Status status;  ///< kCheckFailed if the stage failed; else kOk
  CheckPhase phase;
  std::int32_t next;  ///< the next segment whose joint is looked at
  Proof proof;
  TrackProof at_end;  ///< of the plan's end: for how long it may rest there
  ProofReport found;  ///< why the stage failed
  PlanHints hints;
};

void check_begin(CheckStage& stage) noexcept;

/// Proves that a curve has room: it keeps clear of obstacles and fences as a plan with this curve must, and of
/// obstacles, keep-outs and what is outside the boundary by `spare` metres more. Nothing else is proven. kDone, or
/// kFailed with the reason in `stage`. `world` may be null.
Progress room_advance(CheckStage& stage, const Grid& grid, const Trajectory& part, const AskedWorld* world,
                      double spare, Work& work) noexcept;

/// kDone, or kFailed with the reason in `stage`. Reads its arguments only. The corridor may be empty, or wrong.
Progress check_advance(CheckStage& stage, const Grid& grid, const Corridor& corridor, const Trajectory& trajectory,
                       const CheckQuery& query, Work& work) noexcept;

/// Of a check that is done: until when the plan's end is clear of the tracks, s since the trajectory's beginning, or
/// infinity.
double rest_clear_until(const CheckStage& stage) noexcept;

/// True if the plan passes the vias at query.joints, in order, within each tolerance, and at rest or with the velocity
/// that the via asks for. If not, `found` receives the reason.
bool vias_met(const Grid& grid, const Trajectory& trajectory, const CheckQuery& query, ProofReport& found) noexcept;

}  // namespace tern

#endif
