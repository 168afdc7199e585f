// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/corridor_stage.hpp"

#include "base/math.hpp"
#include "corridor/ellipsoid_fit.hpp"
#include "corridor/reuse.hpp"

namespace tern {
namespace {

std::int32_t legs_of(const Path& path) {
  return path.count - 1;
}

/// Where piece `index` of the leg ends; the last one exactly at the waypoint.
Vec3 piece_end(const CorridorStage& stage, const Path& path) {
  const Vec3& to = path.points[stage.leg + 1];
  if (stage.piece + 1 == stage.pieces) return to;
  const Vec3& from = path.points[stage.leg];
  const double share = static_cast<double>(stage.piece + 1) / static_cast<double>(stage.pieces);
  return from + share * (to - from);
}

/// Segments that the path still needs after the pieces at hand: one a leg, one a piece of this leg.
std::int32_t segments_ahead(const CorridorStage& stage, const Path& path) {
  return (legs_of(path) - stage.leg - 1) + (stage.pieces - stage.piece - 1);
}

/// Equal pieces of at most kLongLeg, as far as there is room beside one segment for each later leg.
std::int32_t pieces_of(const CorridorStage& stage, const Path& path, std::int32_t used) {
  const double length = distance(path.points[stage.leg], path.points[stage.leg + 1]);
  const std::int32_t room = kMaxSegments - used - (legs_of(path) - stage.leg - 1);
  std::int32_t pieces = 1;
  while (pieces < room && length > kLongLeg * static_cast<double>(pieces)) ++pieces;
  return pieces;
}

void begin_leg(CorridorStage& stage, const Path& path, std::int32_t leg, std::int32_t used) {
  stage.leg = leg;
  stage.piece = 0;
  stage.pieces = pieces_of(stage, path, used);
  stage.from = path.points[leg];
  stage.pending = 1;
  stage.ends[0] = piece_end(stage, path);
}

/// Cuts the piece at hand in its middle. `why` where it is a point or was halved often enough.
Status halve(CorridorStage& stage, const Path& path, std::int32_t used, Status why) {
  const Vec3& to = stage.ends[stage.pending - 1];
  if (stage.pending > kMaxHalvings || distance(stage.from, to) < kPointLike) return why;
  if (used + stage.pending + 1 + segments_ahead(stage, path) > kMaxSegments) return Status::kSegmentsFull;
  stage.ends[stage.pending++] = 0.5 * (stage.from + to);
  return Status::kRunning;
}

/// Turns to the next piece, whole; kOk past the last.
Status next_piece(CorridorStage& stage, const Path& path, std::int32_t used) {
  if (++stage.piece < stage.pieces) {
    stage.pending = 1;
    stage.ends[0] = piece_end(stage, path);
    return Status::kRunning;
  }
  if (stage.leg + 1 >= legs_of(path)) return Status::kOk;
  begin_leg(stage, path, stage.leg + 1, used);
  return Status::kRunning;
}

/// Moves on past a finished polyhedron, which also serves the pieces that it holds; kOk past the last. Half a piece is
/// always built: else halvings would not be bounded by the polyhedra they make.
Status move_on(CorridorStage& stage, const Path& path, double margin, std::int32_t used, Polyhedron& finished) {
  stage.from = stage.ends[--stage.pending];
  if (stage.pending > 0) return Status::kRunning;
  Status status = next_piece(stage, path, used);
  while (status == Status::kRunning && holds(finished, stage.ends[0], margin)) {
    extend_segment(finished, stage.ends[0]);
    stage.from = stage.ends[0];
    status = next_piece(stage, path, used);
  }
  return status;
}

/// Tries the piece at hand.
Status try_piece(CorridorStage& stage, const Grid& grid, const Path& path, Corridor& out) {
  if (out.count + segments_ahead(stage, path) + stage.pending > kMaxSegments) return Status::kSegmentsFull;
  const Vec3 to = stage.ends[stage.pending - 1];
  const Status status = grow_polyhedron(grid, stage.from, to, stage.grow, out.polyhedra[out.count]);
  stage.planes = stage.grow.planes;
  stage.planes_high = stage.grow.planes_high;
  stage.boxes_high = stage.grow.boxes_high;
  if (status == Status::kPlanesFull || status == Status::kObstaclesFull) return halve(stage, path, out.count, status);
  if (status != Status::kOk) return status;
  Polyhedron& finished = out.polyhedra[out.count++];
  return move_on(stage, path, kSightMargin * grid.spec().cell, out.count, finished);
}

}  // namespace

void corridor_begin(CorridorStage& stage, const Grid&, const Path& path, std::uint32_t max_planes,
                    const Fences* fences) noexcept {
  stage.planes = 0;
  stage.planes_high = 0;
  stage.boxes_high = 0;
  reset_counters(stage.grow);
  stage.grow.planes_allowed = max_planes;
  stage.grow.fences = fences;
  stage.leg = -1;
  stage.piece = 0;
  stage.pieces = 0;
  stage.pending = 0;
  stage.from = path.points[0];
}

Status corridor_advance(CorridorStage& stage, const Grid& grid, const Path& path, Work& work, Corridor& out) noexcept {
  if (legs_of(path) < 1 || legs_of(path) > kMaxSegments) return Status::kSegmentsFull;
  if (stage.leg < 0) {
    out.count = 0;
    begin_leg(stage, path, 0, 0);
  }
  Status status = Status::kRunning;
  while (status == Status::kRunning && work.take()) status = try_piece(stage, grid, path, out);
  return status;
}

}  // namespace tern
