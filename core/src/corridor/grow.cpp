// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/grow.hpp"

#include "base/math.hpp"
#include "base/polyhedron.hpp"
#include "corridor/improve.hpp"
#include "corridor/redundancy.hpp"
#include "corridor/separation.hpp"
#include "corridor/solid_planes.hpp"
#include "corridor/tangent_planes.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "grid/distance.hpp"
#include "tern/halfspace.hpp"

namespace tern {
namespace {

/// Least semi-axis of the ellipsoid that the first half-spaces are tangent to, as a share of the segment's half length.
constexpr double kThickness = 0.3;

/// The least distance to a plane that the barrier uses, in voxels. It is less than half the width of a tunnel, so it
/// blurs no shape.
constexpr double kLeastSlackCells = 0.1;

/// A wall is compared with both ends of the segment. For a solid, up to three gaps are computed.
Operations solids_operations(const World& world) {
  return ops::kPiece * world.wall_count() + 3 * kGapOperations * world.solid_count();
}

/// The box around the segment that the polyhedron stays in.
Box local_box(const Grid& grid, const Vec3& from, const Vec3& to, double margin) {
  const Box boundary = grid.local_boundary();
  Box box;
  for (int a = 0; a < 3; ++a) {
    const double low = smaller(axis(from, a), axis(to, a));
    const double high = larger(axis(from, a), axis(to, a));
    axis(box.lower, a) = larger(low - margin, axis(boundary.lower, a));
    axis(box.upper, a) = smaller(high + margin, axis(boundary.upper, a));
  }
  return box;
}

Status append_faces(const Box& box, GrowScratch& scratch, Polyhedron& out) {
  Halfspace faces[kBoxPlanes];
  box_planes(box, faces);
  Status status = Status::kOk;
  for (int k = 0; k < kBoxPlanes && status == Status::kOk; ++k) status = append(faces[k], scratch, out);
  return status;
}

/// The diagonal of the local box, computed from the first six half-spaces.
double box_diagonal(const Polyhedron& polyhedron) {
  const Halfspace* faces = polyhedron.planes;
  const Vec3 extent{faces[0].offset + faces[1].offset, faces[2].offset + faces[3].offset,
                    faces[4].offset + faces[5].offset};
  return length(extent);
}

/// The analytic centre or the segment's middle, whichever is deeper inside. The centre may lie outside if the
/// polyhedron is thinner than the barrier's least slack. The middle may lie on a plane that the segment touches.
Vec3 inner_point(const Polyhedron& polyhedron, const Vec3& center, const SegmentMargin& segment) {
  const Vec3 middle = 0.5 * (segment.from + segment.to);
  return room_at(polyhedron, center) < room_at(polyhedron, middle) ? middle : center;
}

bool within(const Box& boundary, const Vec3& p, double tolerance) {
  for (int a = 0; a < 3; ++a) {
    if (axis(p, a) < axis(boundary.lower, a) - tolerance) return false;
    if (axis(p, a) > axis(boundary.upper, a) + tolerance) return false;
  }
  return true;
}

Enclosure enclosure_of(const Growth& growth, const GridSpec& spec, const GrowScratch& scratch) {
  const Obstacles obstacles{scratch.boxes, growth.sieve.kept, spec.clearance()};
  return {obstacles, growth.segment, kLeastSlackCells * spec.cell, growth.given};
}

/// Makes the half-spaces that come before those for obstacles: the faces of the local box, walls and solids.
Progress make_box(Growth& growth, const World& world, GrowScratch& scratch, Polyhedron& out, Work& work) {
  if (!work.left()) return Progress::kMore;
  const Grid& grid = world.voxels();
  const SegmentMargin& segment = growth.segment;
  const Box box = local_box(grid, segment.from, segment.to, growth.reach);
  out.count = 0;
  Status status = append_faces(box, scratch, out);
  if (status == Status::kOk) status = append_solid_planes(world, box, segment, scratch, out);
  growth.given = out.count;
  extract_begin(voxels_within_reach(grid, box), scratch.extract);
  work.spend(ops::kPiece * (1 + kBoxPlanes) + solids_operations(world));
  return conclude(status, growth.status);
}

Progress extract(Growth& growth, const Grid& grid, GrowScratch& scratch, Work& work) {
  const Progress progress = extract_advance(grid, scratch.extract, scratch.boxes, work);
  if (progress == Progress::kMore) return progress;
  const bool full = progress == Progress::kFailed;
  raise(scratch.boxes_high, full ? kMaxLocalBoxes : scratch.extract.count);
  fit_begin(growth.fit, growth.segment.from, growth.segment.to, grid.spec().cell);
  growth.sieve = {0, 0};
  return conclude(full ? Status::kObstaclesFull : Status::kOk, growth.status);
}

Progress fit(Growth& growth, const Grid& grid, GrowScratch& scratch, Work& work) {
  const Obstacles all{scratch.boxes, scratch.extract.count, grid.spec().clearance()};
  const Progress progress = fit_advance(growth.fit, all, scratch.remaining, work);
  if (progress == Progress::kDone) {
    tangents_begin(growth.pass, metric_of(at_least_as_thick(growth.fit.frame, kThickness)));
    improve_begin(growth.improvement);
  }
  return progress;
}

/// Drops the redundant half-spaces, and completes the polyhedron.
Progress finish(Growth& growth, GrowScratch& scratch, Polyhedron& out, Work& work) {
  if (!work.left()) return Progress::kMore;
  const SegmentMargin& segment = growth.segment;
  const Vec3 inside = inner_point(out, to_vec3(growth.improvement.center), segment);
  const int made = out.count;
  const int cuts = drop_redundant(out, inside, box_diagonal(out), scratch.trial.planes);
  out.from = segment.from;
  out.to = segment.to;
  work.spend(ops::kPiece * (1 + kBoxPlanes) + 16 * ops::kDot * (made + cuts));
  return Progress::kDone;
}

/// Goes on with the current phase; kDone at its end.
Progress advance_phase(Growth& growth, const World& world, GrowScratch& scratch, Polyhedron& out, Work& work) {
  const Grid& grid = world.voxels();
  const GridSpec& spec = grid.spec();
  switch (growth.phase) {
    case GrowPhase::kBox:
      return make_box(growth, world, scratch, out, work);
    case GrowPhase::kExtract:
      return extract(growth, grid, scratch, work);
    case GrowPhase::kFit:
      return fit(growth, grid, scratch, work);
    case GrowPhase::kSieve:
      return keep_uncut(growth.sieve, out, spec.clearance(), scratch.boxes, scratch.extract.count, work);
    case GrowPhase::kCutOff:
      return tangents_advance(growth.pass, enclosure_of(growth, spec, scratch).obstacles, growth.segment, scratch, out,
                              work, growth.status);
    case GrowPhase::kImprove:
      return improve_advance(growth.improvement, enclosure_of(growth, spec, scratch), scratch, out, work,
                             growth.status);
    case GrowPhase::kFinish:
      return finish(growth, scratch, out, work);
  }
  return Progress::kDone;
}

/// Begins again with a smaller local box. False if that cannot help, or if there is no smaller one.
bool shrink_box(Growth& growth) {
  const bool full = growth.status == Status::kPlanesFull || growth.status == Status::kObstaclesFull;
  if (!full || growth.level + 1 == kBoxLevels) return false;
  ++growth.level;
  growth.reach *= 0.5;
  growth.phase = GrowPhase::kBox;
  return true;
}

}  // namespace

void grow_begin(Growth& growth, const World& world, const Vec3& from, const Vec3& to) noexcept {
  const double cell = world.spec().cell;
  growth.status = Status::kOk;
  growth.phase = GrowPhase::kBox;
  growth.level = 0;
  growth.reach = larger(kLocalMargin, kLocalMarginCells * cell);
  growth.segment = {from, to, kSightMargin * cell, world.touching(), direction_tolerance(world.spec())};
}

Progress grow_advance(Growth& growth, const World& world, GrowScratch& scratch, Polyhedron& out, Work& work) noexcept {
  const SegmentMargin& segment = growth.segment;
  const Box boundary = world.voxels().local_boundary();
  if (!within(boundary, segment.from, segment.touching) || !within(boundary, segment.to, segment.touching)) {
    return conclude(Status::kOutOfMap, growth.status);
  }
  // Each turn ends a phase; each size of the local box has each phase once at most.
  while (true) {
    const Progress progress = advance_phase(growth, world, scratch, out, work);
    if (progress == Progress::kMore) return progress;
    if (progress == Progress::kFailed) {
      if (!shrink_box(growth)) return progress;
    } else if (growth.phase == GrowPhase::kFinish) {
      return progress;
    } else {
      growth.phase = static_cast<GrowPhase>(static_cast<int>(growth.phase) + 1);
    }
  }
}

}  // namespace tern
