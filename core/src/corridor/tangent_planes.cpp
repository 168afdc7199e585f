// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/tangent_planes.hpp"

#include "base/linear.hpp"
#include "grid/touching.hpp"

namespace tern {
namespace {

/// A box counts as cut off even if it falls short by this much, relative to the size of its coordinates. Otherwise
/// rounding would give each box of a row along one face a half-space of its own.
constexpr double kRounding = 1e-15;
/// Stands for the scale of the second box if only one remains: above all scales that matter.
constexpr double kNoOther = 1e300;

bool cut_off(const Halfspace& plane, const LocalBox& box, double radius) {
  const double short_of = plane.offset + radius - support(plane.normal, box_of(box));
  if (short_of <= 0.0) return true;
  // Local coordinates are not negative, except at boundaries on the grid's own edge, so their sum measures their size.
  return short_of <= kRounding * (1.0 + ((box.upper[0] + box.upper[1]) + box.upper[2]));
}

/// Lists more obstacles as remaining, each with a lower bound of the scale at which the ellipsoid meets it.
void list_some(TangentPass& pass, const Obstacles& obstacles, GrowScratch& scratch, Work& work) {
  const int begin = pass.listed;
  const int end = obstacles.count - begin < kListed ? obstacles.count : begin + kListed;
  for (int i = begin; i < end; ++i) {
    scratch.scale[i] = least_scale(pass.metric, obstacles.boxes[i], obstacles.radius);
    scratch.remaining[i] = i;
  }
  pass.listed = end;
  work.spend(ops::kPiece + kScaleOperations * (end - begin));
}

/// The remaining box with the least scale, or bound of a scale; of equals, the one with the lowest index.
struct Nearest {
  int place;  ///< among the remaining
  double scale;
  double second;  ///< the least scale or bound of all others
};

Nearest nearest_remaining(const GrowScratch& scratch, int count) {
  Nearest nearest{0, scratch.scale[0], kNoOther};
  for (int k = 1; k < count; ++k) {
    const double scale = scratch.scale[k];
    if (!(scale < nearest.second)) continue;
    if (scale < nearest.scale) {
      nearest = {k, scale, nearest.scale};
    } else {
      nearest.second = scale;
    }
  }
  return nearest;
}

/// Computes the contact of the remaining box with the least bound, and replaces the bound by the contact's scale. Most
/// boxes are cut off before their bound is the least, and never need a contact. True once a box with a contact has the
/// least scale: the growing ellipsoid meets that box first.
bool meets_first(TangentPass& pass, const Obstacles& obstacles, GrowScratch& scratch, Work& work) {
  work.spend(ops::kPiece + ops::kTurn * pass.count);
  const Nearest nearest = nearest_remaining(scratch, pass.count);
  if (nearest.place == pass.met) return true;
  const LocalBox& box = obstacles.boxes[scratch.remaining[nearest.place]];
  pass.met = nearest.place;
  pass.contact = contact_of(pass.metric, box, obstacles.radius);
  work.spend(kContactOperations);
  scratch.scale[nearest.place] = pass.contact.scale;
  // Each look but the last two turns a bound into a scale.
  return pass.contact.scale < nearest.second || ++pass.looks == pass.count + 2;
}

/// Keeps the remaining boxes that the half-space does not cut off. The box `made_for` is always dropped, because the
/// offset was computed from it.
int drop_cut_off(const Halfspace& plane, const Obstacles& obstacles, std::int32_t made_for, GrowScratch& scratch,
                 int count) {
  int kept = 0;
  for (int k = 0; k < count; ++k) {
    const std::int32_t i = scratch.remaining[k];
    if (i == made_for || cut_off(plane, obstacles.boxes[i], obstacles.radius)) continue;
    scratch.scale[kept] = scratch.scale[k];
    scratch.remaining[kept++] = i;
  }
  return kept;
}

/// Makes the half-space for the box that is met first.
Status cut_off_met(TangentPass& pass, const Obstacles& obstacles, const SegmentMargin& segment, GrowScratch& scratch,
                   Polyhedron& out, Work& work) {
  work.spend(kContactOperations + ops::kDot * pass.count);
  const std::int32_t box = scratch.remaining[pass.met];
  Halfspace plane;
  Status status = separate(segment, obstacles.boxes[box], obstacles.radius, to_vec3(pass.contact.normal), plane);
  if (status == Status::kOk) status = append(plane, scratch, out);
  if (status != Status::kOk) return status;
  pass.count = drop_cut_off(plane, obstacles, box, scratch, pass.count);
  pass.met = -1;
  pass.looks = 0;
  return Status::kOk;
}

}  // namespace

Progress keep_uncut(Sieve& sieve, const Polyhedron& polyhedron, double radius, LocalBox* boxes, int count,
                    Work& work) noexcept {
  while (sieve.next < count) {
    if (!work.left()) return Progress::kMore;
    const int end = count - sieve.next < kSieved ? count : sieve.next + kSieved;
    int tests = end - sieve.next;
    for (; sieve.next < end; ++sieve.next) {
      bool cut = false;
      int p = 0;
      for (; p < polyhedron.count && !cut; ++p) cut = cut_off(polyhedron.planes[p], boxes[sieve.next], radius);
      if (!cut) boxes[sieve.kept++] = boxes[sieve.next];
      tests += p;
    }
    work.spend(ops::kPiece + 2 * ops::kDot * tests);
  }
  return Progress::kDone;
}

void tangents_begin(TangentPass& pass, const EllipsoidMetric& metric) noexcept {
  pass.metric = metric;
  pass.listed = 0;
  pass.count = 0;
  pass.met = -1;
  pass.looks = 0;
}

Progress tangents_advance(TangentPass& pass, const Obstacles& obstacles, const SegmentMargin& segment,
                          GrowScratch& scratch, Polyhedron& out, Work& work, Status& status) noexcept {
  for (; pass.listed < obstacles.count; pass.count = pass.listed) {
    if (!work.left()) return Progress::kMore;
    list_some(pass, obstacles, scratch, work);
  }
  while (pass.count > 0) {
    if (!work.left()) return Progress::kMore;
    if (!meets_first(pass, obstacles, scratch, work)) continue;
    const Status made = cut_off_met(pass, obstacles, segment, scratch, out, work);
    if (made != Status::kOk) return conclude(made, status);
  }
  return conclude(Status::kOk, status);
}

}  // namespace tern
