// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "trajectory/programme_points.hpp"
#include "trajectory/separations.hpp"

namespace tern {
namespace {

/// The control points of the part from u to v as weights of the segment's.
struct PartWeights {
  double w[kControlPoints][kControlPoints];
};

PartWeights part_weights(double u, double v) {
  PartWeights part;
  for (int m = 0; m < kControlPoints; ++m) {
    double column[kControlPoints] = {};
    column[m] = 1.0;
    if (v < 1.0) keep_first_part(v, column);
    if (u > 0.0 && v > 0.0) keep_last_part(u / v, column);
    for (int k = 0; k < kControlPoints; ++k) part.w[k][m] = column[k];
  }
  return part;
}

/// Where the thing is over the rows' time, along the normal, with what is to be kept from it. The stretch is that of a
/// plan that rests at the origin.
void read_thing(const Things& things, const Track& track, const Stretch& stretch, SeparationRows& rows) {
  rows.length = stretch.end - stretch.begin;
  rows.u = stretch.u;
  rows.v = stretch.v;
  const double more = support_of(things, track, rows.normal) + kSeparationMargin;
  for (int k = 0; k < kControlPoints; ++k) {
    rows.behind[k] = stretch.need[k] - dot(rows.normal, stretch.points[k]) + more;
  }
}

/// Appends the rows of one stretch.
void add_rows(const Chain& chain, const SeparationRows& rows, ProgrammeScale& scale, QpProblem& problem) {
  const Piece piece = piece_of(chain, scale, rows.segment);
  const PartWeights part = part_weights(rows.u, rows.v);
  const int point_begin = problem.point_count;
  const double centre = dot(rows.normal, chain.center);
  for (int k = 0; k < kControlPoints; ++k) {
    const PointOrigin origin{rows.segment, kSeparationOrder, static_cast<std::int8_t>(k)};
    if (!add_point(piece, end_weights(part.w[k]), 1.0, origin, scale, problem)) continue;
    Vec3& offset = problem.points[problem.point_count - 1].offset;
    offset = offset - (rows.behind[k] - centre) * rows.normal;
  }
  if (point_begin == problem.point_count) return;
  problem.planes[problem.plane_count] = Halfspace{-1.0 * rows.normal, 0.0};
  ++problem.plane_count;
  add_group(point_begin, problem.plane_count - 1, problem.plane_count, problem);
}

/// The control point k of the rate of change of `behind` if its time moves by u at its beginning and by v at its end.
double rate_at(const SeparationRows& rows, int k, double u, double v) {
  const double scale = kDegree / rows.length;
  double rate = 0.0;
  if (k < kDegree) rate += (kDegree - k) * u * (scale * (rows.behind[k + 1] - rows.behind[k]));
  if (k > 0) rate += k * v * (scale * (rows.behind[k] - rows.behind[k - 1]));
  return rate / kDegree;
}

const SeparationRows* rows_of(const Separations& separations, int point) {
  const SeparationRows* found = nullptr;
  for (int i = 0; i < separations.rows_count && separations.rows[i].point_begin <= point; ++i) {
    found = separations.rows + i;
  }
  return found;
}

}  // namespace

bool add_separations(const Chain& chain, const Scene& scene, Separations& separations, ProgrammeScale& scale,
                     QpProblem& problem, Work& work) noexcept {
  Operations spent = 0;
  separations.rows_count = 0;
  for (int i = 0; i < separations.count; ++i) {
    const Separation& separation = separations.list[i];
    const Track& track = scene.things.tracks[separation.track];
    const double begin = begin_of(chain, scene, separation.segment);
    const Vec3 nowhere[kControlPoints] = {};
    const TimedCurve curve{nowhere, begin, chain.duration[separation.segment]};
    double from = begin;
    Stretch stretch;
    for (int n = 0; n < kMostSpans && next_stretch(scene.things, track, curve, from, stretch, spent); ++n) {
      if (is_full(separations.rows_count == kMaxSeparations)) {
        separations.is_full = true;
        return false;
      }
      SeparationRows& rows = separations.rows[separations.rows_count];
      rows.segment = separation.segment;
      rows.normal = separation.normal;
      rows.point_begin = problem.point_count;
      ease_leaving(separations.leave[separation.track], stretch);
      read_thing(scene.things, track, stretch, rows);
      add_rows(chain, rows, scale, problem);
      ++separations.rows_count;
      from = stretch.end;
    }
  }
  work.spend(spent + kRowsOperations * separations.rows_count);
  return true;
}

void add_separation_prices(const Chain& chain, const QpSolution& solution, const ProgrammeScale& scale,
                           const Vec3 (*points)[kControlPoints], const Separations& separations,
                           double* prices) noexcept {
  double shift[kMaxSegments] = {};
  for (int r = 0; r < solution.active_count; ++r) {
    const QpConstraint& active = solution.active[r];
    const PointOrigin& origin = scale.origin[active.point];
    if (origin.order != kSeparationOrder) continue;
    const SeparationRows& rows = *rows_of(separations, active.point);
    const int i = origin.segment;
    const double pressure = scale.snap_per_cost * solution.multiplier[r];
    Vec3 drift[kControlPoints];
    drift_of(points[i], drift);
    const PartWeights part = part_weights(rows.u, rows.v);
    Vec3 change = kZero;
    for (int m = 0; m < kControlPoints; ++m) change = change + part.w[origin.index][m] * drift[m];
    const double own = chain.duration[i] * rate_at(rows, origin.index, rows.u, rows.v);
    prices[i] += pressure * (dot(rows.normal, change) - own);
    shift[i] += pressure * rate_at(rows, origin.index, 1.0, 1.0);
  }
  double later = 0.0;
  for (int i = chain.count - 1; i >= 0; --i) {
    prices[i] -= later * chain.duration[i];
    later += shift[i];
  }
}

}  // namespace tern
