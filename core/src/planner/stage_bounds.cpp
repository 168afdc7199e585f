// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/corridor_stage.hpp"
#include "grid/stencil.hpp"
#include "path/reach_stage.hpp"
#include "path/search_stage.hpp"
#include "path/shortcut_stage.hpp"
#include "planner/around.hpp"
#include "planner/detour.hpp"
#include "planner/end_stop.hpp"
#include "planner/hints.hpp"
#include "planner/ledger.hpp"
#include "planner/moving.hpp"
#include "planner/previous.hpp"
#include "planner/timed_seed.hpp"
#include "prove/check_stage.hpp"
#include "qp/operations.hpp"
#include "times/pace.hpp"
#include "times/times_stage.hpp"
#include "trajectory/trajectory_stage.hpp"
#include "world/solid_layer.hpp"

namespace tern {
namespace {

Operations most(Operations a, Operations b) {
  return a < b ? b : a;
}

Operations rows_of(const GridSpec& spec) {
  return Operations{spec.dims.y} * spec.dims.z;
}

Operations row_words(const GridSpec& spec) {
  return (spec.dims.x + 63) / 64;
}

/// Every row of the grid, and every word of each.
Operations all_rows(const GridSpec& spec) {
  return rows_of(spec) * (ops::kRow + ops::kWord * row_words(spec));
}

StageBound world_bound(const GridSpec& spec) {
  const Operations plane = 2 * ops::kPiece + kStencilOperations + 12 * ops::kDot * kMaxSolidNormals +
                           (kMaxSolidNormals + 2) * ops::kRow * spec.dims.y + solid_plane_operations(spec) +
                           ops::kElement * row_words(spec) * spec.dims.y;
  return {std::uint64_t{kMaxSolids + 1} * static_cast<std::uint64_t>(spec.dims.z), plane};
}

/// An expansion of the optimal search takes longest: each move sweeps, and jumps straight from each step of each sweep.
/// Each piece may also begin a search, and the last one writes the path.
StageBound search_bound(const GridSpec& spec) {
  const Operations straight = 2 * ops::kNode;
  const Operations plane = kSweepSteps * (2 * ops::kNode + 2 * straight);
  const Operations space = kSweepSteps * (2 * ops::kNode + 3 * plane + 3 * straight);
  const Operations ends = 2 * (2 * kSearchedOperations + ops::kTurn * kMaxJoins * kMaxJoins) + all_rows(spec);
  const Operations path = ops::kNode * (kMaxJumpPoints + Operations{spec.dims.x} * rows_of(spec));
  const Operations cells = Operations{spec.dims.x} * rows_of(spec) / kWordBits + ops::kRow * Operations{kMaxNodes};
  return {std::uint64_t{kSearchBound} + kFinerHalvings * kJoinCells + kMaxDimension,
          8 * space + 12 * plane + 6 * straight + ends + path + cells};
}

StageBound reach_bound(const GridSpec& spec) {
  return {std::uint64_t{kReachBound} + 2 * kMaxDimension,
          4 * ops::kPiece + kSearchedOperations + ops::kTurn * kMaxJoins * kMaxJoins + all_rows(spec)};
}

StageBound shortcut_bound(const GridSpec& spec) {
  return {kShortcutBound, 8 * ops::kPiece + 2 * ops::kRow * (spec.dims.y + Operations{spec.dims.z})};
}

StageBound detour_bound(const GridSpec& spec) {
  return {1, 2 * kBrakeShapes * ops::kCurve + Operations{kDetourLines} * (2 * ops::kPiece + 4 * all_rows(spec))};
}

/// The longest piece of extracting boxes or of walls and solids, for a polyhedron around a leg.
Operations room_piece(const GridSpec& spec) {
  const Operations layer = ops::kPiece + 2 * ops::kWord * row_words(spec) * spec.dims.y +
                           (ops::kRow + 8 * ops::kTurn * kMaxRowRuns) * spec.dims.y +
                           16 * ops::kTurn * Operations{kMaxLocalBoxes};
  const Operations solids = ops::kPiece * 8 + 8 * ops::kDot * kMaxWalls + 4 * kGapOperations * kMaxSolids;
  const Operations contacts = 4 * kContactOperations + 2 * ops::kDot * Operations{kMaxLocalBoxes};
  return most(most(layer, solids), contacts) + 32 * ops::kPiece * kMaxPlanes;
}

/// Of a polyhedron around a leg, the tangents take most pieces: a look for each box, for each half-space.
StageBound corridor_bound(const GridSpec& spec) {
  const std::uint64_t boxes = kMaxLocalBoxes;
  const std::uint64_t tangents = boxes + std::uint64_t{kMaxPlanes} * (boxes + 2);
  const std::uint64_t fit = 2 * (17 * boxes + 1) + boxes;
  const std::uint64_t pieces = (1 + kImprovingRounds + kLeaveOuts) * tangents + fit + kMaxDimension + 4 * kMaxPlanes;
  return {kCorridorTries * kBoxLevels * pieces, room_piece(spec)};
}

/// The operations of the longest piece of a proof, or of finding hints for it.
Operations proof_piece(const GridSpec& spec) {
  return most(check_piece_operations(spec), kHintOperations);
}

/// The bound of proofs that `segments` segments have room.
StageBound room_bound(const GridSpec& spec, std::uint64_t segments) {
  return {segments * (kProofPieces + 2 + kMaxSolids), proof_piece(spec) + kStopOperations};
}

/// A segment may look at all pieces of the plan that sets the pace.
StageBound times_bound() {
  return {kTimesBound, ops::kCurve * (1 + kPacePieces * Operations{kMaxSegments}) + ops::kPiece};
}

/// An iteration enters a row after pricing all points, drops one, and may measure the answer. Each also pays its share
/// of the assembly and judgement of its programme.
StageBound trajectory_bound() {
  constexpr Operations kBand = ops::kMultiplyAdd * kQpAxes * (kQpBand + 1) * kQpMaxUnknowns;
  constexpr Operations kBasis = ops::kPiece + ops::kElement * kQpMaxRank * Operations{kQpMaxDimension};
  constexpr Operations kTriangle = (ops::kElement + ops::kTurn) * kQpMaxRank * (kQpMaxRank + 1);
  constexpr Operations kRotations = 2 * ops::kElement * kQpMaxRank * Operations{kQpMaxDimension + kQpMaxRank};
  constexpr Operations kLimitPlanes = 22 + kQpThrustPlanes;
  constexpr Operations kPlanes = kLimitPlanes > kMaxPlanes ? kLimitPlanes : Operations{kMaxPlanes};
  constexpr Operations kPrice =
      3 * kQpMaxBatches * (2 * ops::kPiece + kQpBatch * (qp::kPointOperations + ops::kElement * 3 * kPlanes));
  constexpr Operations kMeasure = 4 * kBand + 2 * qp::kConstraintOperations * (kQpMaxRank + 2);
  constexpr Operations kIteration = 8 * kBasis + 4 * kTriangle + kRotations + 3 * (kPrice + kMeasure + 3 * kBand);
  constexpr Operations kProgramme = 4 * kBand + 8 * ops::kDot * Operations{kQpMaxPoints} +
                                    (3 * ops::kDot + ops::kPiece) * Operations{kQpMaxPlanes} +
                                    40 * ops::kCurve * kMaxSegments + 400 * ops::kCurve;
  constexpr Operations kJudgement = 2 * (16 * ops::kCurve * kMaxSegments + 2 * ops::kPiece * (kMaxActive + 1)) +
                                    2 * ops::kCurve * (kMaxSegments + kBrakingsTried) + kRateOperations * kMaxSegments;
  return {std::uint64_t{kTrajectoryBound} + 2 * kMaxQpSolves + 4, kIteration + kProgramme + kJudgement};
}

}  // namespace

StageBound stage_bound(Stage stage, const GridSpec& spec) noexcept {
  switch (stage) {
    case Stage::kWorld:
      return world_bound(spec);
    case Stage::kSearch:
      return search_bound(spec);
    case Stage::kShortcut:
      return shortcut_bound(spec);
    case Stage::kCorridor:
      return corridor_bound(spec);
    case Stage::kTimes:
      return times_bound();
    case Stage::kTrajectory:
      return trajectory_bound();
    case Stage::kCheck:
      return {kCheckBound + kHintBound, proof_piece(spec)};
    case Stage::kDetour:
      return detour_bound(spec);
    case Stage::kPrevious:
      return room_bound(spec, 2 * kMaxSegments);
    case Stage::kStopFirst:
      return room_bound(spec, std::uint64_t{2 * kStoppingChoices + kArrivals} * kStoppingSegments);
    case Stage::kReach:
      return reach_bound(spec);
    case Stage::kTracks: {
      const StageBound proof = tracks_bound(kMaxTracks);
      return {kTimedProofs * (proof.pieces + 1), proof.piece + ops::kCurve * kMaxSegments};
    }
    case Stage::kRequest:
      break;
  }
  return {0, 0};
}

StageBound around_bound(std::int32_t count) noexcept {
  const std::uint64_t pairs = std::uint64_t{kMaxSegments} * static_cast<std::uint64_t>(count);
  const Operations planes = kMaxSeparations * (2 * kMeetOperations + kRowsOperations);
  if (count == 0) return {0, 0};
  return {(kMaxQpSolves + 1) * pairs + kMaxQpSolves, kMeetOperations + planes};
}

StageBound timed_bound(std::int32_t count, const GridSpec& spec) noexcept {
  if (count == 0) return {0, 0};
  const Operations sight = ops::kPiece + 2 * ops::kTurn * (spec.dims.y + Operations{spec.dims.z});
  const Operations leg = sight + kMaxFloodLayers * (ops::kPiece + ops::kDot) * Operations{kMaxThings};
  const std::uint64_t floods = (kTimedSeeds + 1) * (kFloodPieces + kMaxFloodLayers * kMaxFloodLayers);
  return {floods + kGoalInstants + 1, kFloodOperations + leg};
}

StageBound tracks_bound(std::int32_t count) noexcept {
  return {count > 0 ? track_bound(count) : 0, kTrackOperations};
}

StageBound windows_bound() noexcept {
  return {kWindowBound, 2 * kAskedOperations + kTrackOperations};
}

}  // namespace tern
