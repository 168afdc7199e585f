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
/// Scale of the next box where only one remains: above all that matter.
constexpr double kNoOther = 1e300;

bool cut_off(const Halfspace& plane, const LocalBox& box, double radius) {
  const double short_of = plane.offset + radius - support(plane.normal, box_of(box));
  if (short_of <= 0.0) return true;
  // Local coordinates are not negative, except at boundaries on the grid's own edge, so their sum measures their size.
  return short_of <= kRounding * (1.0 + ((box.upper[0] + box.upper[1]) + box.upper[2]));
}

/// Lists all boxes as remaining, each with a lower bound of the scale at which the ellipsoid meets it.
void list_all(const EllipsoidMetric& metric, const Obstacles& obstacles, GrowScratch& scratch) {
  for (int i = 0; i < obstacles.count; ++i) {
    scratch.scale[i] = least_scale(metric, obstacles.boxes[i], obstacles.radius);
    scratch.remaining[i] = i;
  }
}

/// The least scale or bound of the remaining boxes; of equals, the first, whose box has the lowest index.
struct Nearest {
  int place;  ///< among the remaining
  double scale;
  double second;  ///< least of all others
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

/// The remaining box that the growing ellipsoid meets first.
struct Met {
  int place;  ///< among the remaining
  Contact contact;
};

/// Computes contacts, the least bound first, until a box with a contact has the least scale. Each contact takes the
/// place of the box's bound. Most boxes are cut off before their bound is the least, and never need one.
Met first_met(const EllipsoidMetric& metric, const Obstacles& obstacles, GrowScratch& scratch, int count) {
  Met met{-1, {}};
  // Each iteration but the last two turns a bound into a scale.
  for (int k = 0; k < count + 2; ++k) {
    const Nearest nearest = nearest_remaining(scratch, count);
    if (nearest.place == met.place) break;
    met = {nearest.place, contact_of(metric, obstacles.boxes[scratch.remaining[nearest.place]], obstacles.radius)};
    scratch.scale[nearest.place] = met.contact.scale;
    if (met.contact.scale < nearest.second) break;
  }
  return met;
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

}  // namespace

int keep_uncut(const Polyhedron& polyhedron, double radius, LocalBox* boxes, int count) noexcept {
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    bool cut = false;
    for (int p = 0; p < polyhedron.count && !cut; ++p) cut = cut_off(polyhedron.planes[p], boxes[i], radius);
    if (!cut) boxes[kept++] = boxes[i];
  }
  return kept;
}

Status append_tangents(const EllipsoidMetric& metric, const Obstacles& obstacles, const SegmentMargin& segment,
                       GrowScratch& scratch, Polyhedron& out) noexcept {
  list_all(metric, obstacles, scratch);
  int count = obstacles.count;
  while (count > 0) {
    const Met met = first_met(metric, obstacles, scratch, count);
    const std::int32_t box = scratch.remaining[met.place];
    Halfspace plane;
    Status status = separate(segment, obstacles.boxes[box], obstacles.radius, to_vec3(met.contact.normal), plane);
    if (status == Status::kOk) status = append(plane, scratch, out);
    if (status != Status::kOk) return status;
    count = drop_cut_off(plane, obstacles, box, scratch, count);
  }
  return Status::kOk;
}

}  // namespace tern
