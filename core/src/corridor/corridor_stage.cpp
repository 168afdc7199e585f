// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/corridor_stage.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "base/polyhedron.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"

namespace tern {
namespace {

std::int32_t legs_of(const Path& path) {
  return path.count - 1;
}

/// The end of the current piece of the leg; the last piece ends exactly at the waypoint.
Vec3 piece_end(const CorridorStage& stage, const Path& path) {
  const Vec3& to = path.points[stage.leg + 1];
  if (stage.piece + 1 == stage.pieces) return to;
  const Vec3& from = path.points[stage.leg];
  const double share = static_cast<double>(stage.piece + 1) / static_cast<double>(stage.pieces);
  return from + share * (to - from);
}

/// Segments that the rest of the path needs: one for each piece left of this leg, and one for each later leg.
std::int32_t segments_ahead(const CorridorStage& stage, const Path& path) {
  return (legs_of(path) - stage.leg - 1) + (stage.pieces - stage.piece - 1);
}

/// The number of equal pieces of this leg. They are at most kLongLeg long, unless later legs would be left without
/// segments.
std::int32_t pieces_of(const CorridorStage& stage, const Path& path) {
  const double length = distance(path.points[stage.leg], path.points[stage.leg + 1]);
  const std::int32_t room = kMaxSegments - kKeptForEnds - stage.built - (legs_of(path) - stage.leg - 1);
  std::int32_t pieces = 1;
  while (pieces < room && length > kLongLeg * static_cast<double>(pieces)) ++pieces;
  return pieces;
}

/// If the leg begins at a via, so does the next polyhedron, number `next`.
void pass_via(CorridorStage& stage, std::int32_t next) {
  ViaMarks* marks = stage.marks;
  stage.at_via = marks != nullptr && stage.passed < marks->count && marks->waypoint[stage.passed] == stage.leg;
  if (!stage.at_via) return;
  marks->polyhedron[stage.passed++] = next;
  stage.fixed = next;
}

void begin_leg(CorridorStage& stage, const Path& path, std::int32_t leg, std::int32_t next) {
  stage.leg = leg;
  pass_via(stage, next);
  stage.piece = 0;
  stage.pieces = pieces_of(stage, path);
  stage.from = path.points[leg];
  stage.pending = 1;
  stage.ends[0] = piece_end(stage, path);
}

/// Cuts the current piece in its middle: kMore. kFailed with `why` if the piece is a point or has been halved
/// kMaxHalvings times; or with kSegmentsFull.
Progress halve(CorridorStage& stage, const Path& path, Status why) {
  const Vec3& to = stage.ends[stage.pending - 1];
  if (stage.pending > kMaxHalvings || distance(stage.from, to) < kPointLike) {
    return conclude(why, stage.status);
  }
  if (is_full(stage.built + stage.pending + 1 + segments_ahead(stage, path) > kMaxSegments)) {
    return conclude(Status::kSegmentsFull, stage.status);
  }
  stage.ends[stage.pending++] = 0.5 * (stage.from + to);
  return Progress::kMore;
}

/// Goes on to the next whole piece: kMore, or kDone after the last.
Progress next_piece(CorridorStage& stage, const Path& path, std::int32_t next) {
  if (++stage.piece < stage.pieces) {
    stage.at_via = false;
    stage.pending = 1;
    stage.ends[0] = piece_end(stage, path);
    return Progress::kMore;
  }
  if (stage.leg + 1 >= legs_of(path)) return Progress::kDone;
  begin_leg(stage, path, stage.leg + 1, next);
  return Progress::kMore;
}

/// True for the last piece of the last leg. Its polyhedron and that of the first piece are never merged with others: a
/// moving start or goal needs all the room of a polyhedron made for it alone.
bool is_last_piece(const CorridorStage& stage, const Path& path) {
  return stage.leg + 1 == legs_of(path) && stage.piece + 1 == stage.pieces;
}

/// Moves on past a finished polyhedron, and past the following pieces that it also contains; kDone after the last
/// piece. Half a piece always gets its own polyhedron, so that the number of polyhedra bounds the number of halvings.
Progress move_on(CorridorStage& stage, const Path& path, double margin, Corridor& out) {
  Polyhedron& finished = out.polyhedra[out.count - 1];
  stage.from = stage.ends[--stage.pending];
  if (stage.pending > 0) return Progress::kMore;
  Progress progress = next_piece(stage, path, out.count);
  while (progress == Progress::kMore && !stage.at_via && !is_last_piece(stage, path) &&
         holds(finished, stage.ends[0], margin)) {
    finished.to = stage.ends[0];
    stage.from = stage.ends[0];
    progress = next_piece(stage, path, out.count);
  }
  return progress;
}

/// Drops polyhedra before the last one as long as the last one contains their lines, too. It need not contain the
/// waypoints that these lines skip. The first polyhedron stays, and so do the first `fixed` ones.
void drop_held(Corridor& out, double margin, std::int32_t fixed) {
  while (out.count > 2 && out.count > fixed + 1) {
    const Polyhedron& last = out.polyhedra[out.count - 1];
    Polyhedron& before = out.polyhedra[out.count - 2];
    if (!holds(last, before.from, margin)) return;
    const Vec3 from = before.from;
    before = last;
    before.from = from;
    --out.count;
  }
}

/// Begins the polyhedron of the current piece. False if the capacity for segments has no room for it.
bool begin_piece(CorridorStage& stage, const World& world, const Path& path) {
  if (is_full(stage.built + segments_ahead(stage, path) + stage.pending > kMaxSegments)) return false;
  grow_begin(stage.growth, world, stage.from, stage.ends[stage.pending - 1]);
  stage.growing = true;
  ++stage.tries;
  return true;
}

/// Goes on after the polyhedron of the current piece is done, or has failed. kMore if pieces are left.
Progress end_piece(CorridorStage& stage, const Grid& grid, const Path& path, Corridor& out) {
  const Status status = stage.growth.status;
  stage.growing = false;
  if (status == Status::kPlanesFull || status == Status::kObstaclesFull) return halve(stage, path, status);
  if (status != Status::kOk) return conclude(status, stage.status);
  ++stage.built;
  ++out.count;
  const double margin = kSightMargin * grid.spec().cell;
  if (!stage.is_timed) drop_held(out, margin, stage.fixed);
  return move_on(stage, path, margin, out);
}

}  // namespace

void corridor_begin(CorridorStage& stage, const Path& path, ViaMarks* marks, bool is_timed) noexcept {
  stage.status = Status::kOk;
  stage.tries = 0;
  stage.planes_high = 0;
  stage.boxes_high = 0;
  reset_counters(stage.grow);
  stage.marks = marks;
  stage.passed = 0;
  stage.at_via = false;
  stage.fixed = 0;
  stage.is_timed = is_timed;
  stage.leg = -1;
  stage.piece = 0;
  stage.pieces = 0;
  stage.pending = 0;
  stage.built = 0;
  stage.growing = false;
  stage.from = path.points[0];
}

Progress corridor_advance(CorridorStage& stage, const World& world, const Path& path, Work& work,
                          Corridor& out) noexcept {
  if (legs_of(path) < 1 || is_full(legs_of(path) > kMaxSegments)) return conclude(Status::kSegmentsFull, stage.status);
  if (stage.leg < 0) {
    out.count = 0;
    begin_leg(stage, path, 0, 0);
  }
  Progress progress = Progress::kMore;
  while (progress == Progress::kMore) {
    if (!stage.growing && !begin_piece(stage, world, path)) return conclude(Status::kSegmentsFull, stage.status);
    const Progress grown = grow_advance(stage.growth, world, stage.grow, out.polyhedra[out.count], work);
    stage.planes_high = stage.grow.planes_high;
    stage.boxes_high = stage.grow.boxes_high;
    if (grown == Progress::kMore) return grown;
    progress = end_piece(stage, world.voxels(), path, out);
  }
  return progress;
}

}  // namespace tern
