// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/separations.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"

namespace tern {
namespace {

/// A plane is added at once if the reference keeps less than this much more than the needed distance, in parts of it.
constexpr double kTrust = 0.3;

TimedCurve curve_at(const Chain& chain, const Scene& scene, const Vec3 (*points)[kControlPoints], int segment) {
  return {points[segment], begin_of(chain, scene, segment), chain.duration[segment]};
}

/// What is left to keep from a thing that the plan leaves, at a time of the plan.
double left_at(double gap, double time) {
  return gap + kLeaveSpeed * larger(0.0, time - kLeaveTime);
}

bool stretch_of(const Scene& scene, const TimedCurve& curve, int track, double gap, double from, Stretch& stretch,
                Work& work) {
  Operations spent = 0;
  const bool found = next_stretch(scene.things, scene.things.tracks[track], curve, from, stretch, spent);
  work.spend(spent);
  if (!found) return false;
  ease_leaving(gap, stretch);
  return true;
}

/// The stretch of the pair that comes nearest, or false if the thing is not there.
bool nearest_stretch(const Scene& scene, const TimedCurve& curve, int track, double gap, Stretch& nearest,
                     Approach& least, Work& work) {
  Stretch stretch;
  least = {1e300, 0.0};
  double from = curve.begin;
  bool found = false;
  for (int i = 0; i < kMostSpans && stretch_of(scene, curve, track, gap, from, stretch, work); ++i) {
    work.spend(kApproachOperations + closest_operations(scene.things, scene.things.tracks[track]));
    const Approach approach = approach_of(scene.things, scene.things.tracks[track], stretch);
    if (!found || approach.room < least.room) {
      least = approach;
      nearest = stretch;
    }
    found = true;
    from = stretch.end;
  }
  return found;
}

bool find_plane(const Separations& separations, int segment, int track) {
  for (int i = 0; i < separations.count; ++i) {
    if (separations.list[i].segment == segment && separations.list[i].track == track) return true;
  }
  return false;
}

Box box_around(const Vec3* points) {
  Box box{points[0], points[0]};
  for (int k = 1; k < kControlPoints; ++k) {
    for (int a = 0; a < 3; ++a) {
      axis(box.lower, a) = smaller(axis(box.lower, a), axis(points[k], a));
      axis(box.upper, a) = larger(axis(box.upper, a), axis(points[k], a));
    }
  }
  return box;
}

double largest_need(const Stretch& stretch) {
  double most = stretch.need[0];
  for (const double need : stretch.need) most = larger(most, need);
  return most;
}

/// True if some points of the segment follow from an end or a via, and have no rows.
bool has_fixed_points(const Chain& chain, int segment) {
  return segment == 0 || segment + 1 == chain.count || chain.via_joint_count > 0;
}

/// Looks at the plan's end while it rests there.
void look_at_end(const Chain& chain, const Scene& scene, const Vec3 (*points)[kControlPoints], Separations& separations,
                 Work& work) {
  Vec3 rest[kControlPoints];
  for (Vec3& point : rest) point = points[chain.count - 1][kDegree];
  const double begin = begin_of(chain, scene, chain.count - 1) + chain.duration[chain.count - 1];
  Stretch stretch;
  Approach least{};
  const TimedCurve curve{rest, begin, scene.rest};
  if (!nearest_stretch(scene, curve, separations.track, -1.0, stretch, least, work)) return;
  if (least.room < 0.0) separations.is_stuck = true;
}

/// Looks at one pair, and gives it a plane if it comes too near.
void look_at_pair(const Chain& chain, const Scene& scene, const Vec3 (*points)[kControlPoints],
                  Separations& separations, Work& work) {
  const int segment = separations.segment;
  const int track = separations.track;
  const Track& thing = scene.things.tracks[track];
  const TimedCurve curve = curve_at(chain, scene, points, segment);
  const double trust = separations.by_reference ? kTrust : 0.0;
  Operations spent = ops::kPiece;
  const bool is_far = is_far_from(scene.things, thing, curve, separations.box, trust, spent);
  work.spend(spent);
  if (is_far) return;
  const bool has_plane = find_plane(separations, segment, track);
  if (has_plane && !has_fixed_points(chain, segment)) return;
  Stretch stretch;
  Approach least{};
  const double gap = separations.leave[track];
  if (!nearest_stretch(scene, curve, track, gap, stretch, least, work)) return;
  if (!(least.room < trust * largest_need(stretch))) return;
  if (has_plane) {
    separations.is_stuck = true;
    return;
  }
  if (is_full(separations.count == kMaxSeparations)) {
    separations.is_full = true;
    return;
  }
  if (!separations.by_reference) {
    const TimedCurve reference{scene.reference->segments[segment].points, curve.begin, curve.duration};
    nearest_stretch(scene, reference, track, gap, stretch, least, work);
  }
  work.spend(kNormalOperations);
  double room = 0.0;
  const Vec3 normal = parting_normal(scene.things, thing, stretch, room);
  separations.list[separations.count] = {static_cast<std::int16_t>(segment), static_cast<std::int16_t>(track), normal};
  ++separations.count;
  ++separations.added;
}

}  // namespace

void separations_begin(const Scene& scene, const Vec3& start, Separations& separations) noexcept {
  separations.is_full = false;
  separations.count = separations.rows_count = 0;
  for (int j = 0; j < scene.things.count; ++j) {
    const Track& track = scene.things.tracks[j];
    const ThingSpan span = thing_at(track, scene.things.begin, 0.0);
    separations.leave[j] = -1.0;
    if (span.kind == ThingSpan::kAbsent) continue;
    const ThingPart part = part_of(scene.things, track, span, 0.0, 0.0);
    const Vec3 from = start - part.points[0];
    const double gap = distance(from, closest_in(scene.things, track, from));
    if (gap < part.need[0]) separations.leave[j] = larger(0.0, gap - kSeparationMargin);
  }
}

void ease_leaving(double gap, Stretch& stretch) noexcept {
  if (gap < 0.0) return;
  const double first = left_at(gap, stretch.begin);
  const double last = left_at(gap, stretch.end);
  for (int k = 0; k < kControlPoints; ++k) {
    stretch.need[k] = smaller(stretch.need[k], first + (k / 7.0) * (last - first));
  }
}

double begin_of(const Chain& chain, const Scene& scene, int segment) noexcept {
  double begin = scene.pause[0];
  for (int i = 0; i < segment; ++i) begin += chain.duration[i] + scene.pause[i + 1];
  return begin;
}

void meet_begin(bool by_reference, Separations& separations) noexcept {
  separations.segment = separations.track = separations.added = 0;
  separations.is_stuck = false;
  separations.by_reference = by_reference;
}

bool meet_advance(const Chain& chain, const Scene& scene, const Vec3 (*points)[kControlPoints],
                  Separations& separations, Work& work) noexcept {
  const int last = scene.rest > 0.0 && !separations.by_reference ? chain.count : chain.count - 1;
  for (int& segment = separations.segment; segment <= last; ++segment) {
    if (separations.track == 0 && segment < chain.count) separations.box = box_around(points[segment]);
    for (int& track = separations.track; track < scene.things.count; ++track) {
      if (!work.left()) return false;
      const bool is_end = segment == chain.count;
      is_end ? look_at_end(chain, scene, points, separations, work)
             : look_at_pair(chain, scene, points, separations, work);
    }
    separations.track = 0;
  }
  return true;
}

void turn_planes(const Chain& chain, const Scene& scene, const Vec3 (*points)[kControlPoints], Separations& separations,
                 Work& work) noexcept {
  work.spend(kNormalOperations * separations.count);
  for (int i = 0; i < separations.count; ++i) {
    Separation& separation = separations.list[i];
    Stretch stretch;
    Approach least{};
    const TimedCurve curve = curve_at(chain, scene, points, separation.segment);
    const double gap = separations.leave[separation.track];
    if (!nearest_stretch(scene, curve, separation.track, gap, stretch, least, work)) continue;
    double room = 0.0;
    const Vec3 normal = parting_normal(scene.things, scene.things.tracks[separation.track], stretch, room);
    if (room >= 0.0) separation.normal = normal;
  }
}

}  // namespace tern
