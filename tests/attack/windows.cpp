// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences for a while: boxes, oblique half-spaces and slabs, some of them keep-ins, and a checker of their own. It looks
// at instants between those at which a fence begins or ends, and proves what lies between by how fast the plan is.
#include "attack/windows.hpp"

#include <algorithm>
#include <cmath>

#include "attack/in_time.hpp"

namespace tern_attack {
namespace {

using tern::Fence;
using tern::FenceKind;
using tern::Halfspace;

/// s: what rounding of times to nanoseconds may do to a window.
constexpr Real kInstant = 2e-9L;

Real window_begin(const Fence& fence, const tern::Trajectory& plan) {
  const Real later = fence.kind == FenceKind::kKeepIn ? fence.clock_error : -fence.clock_error;
  return (static_cast<Real>(fence.from) - static_cast<Real>(plan.begin)) * 1e-9L + later;
}

Real window_end(const Fence& fence, const tern::Trajectory& plan) {
  const Real later = fence.kind == FenceKind::kKeepIn ? fence.clock_error : -fence.clock_error;
  return (static_cast<Real>(fence.until) - static_cast<Real>(plan.begin)) * 1e-9L - later;
}

/// How far a place is beyond a plane, by its unit normal. `p`: relative to `origin`.
Real beyond(const Halfspace& plane, const Point& p, const Point& origin) {
  const Point n = point(plane.normal);
  return (dot(n, p) + dot(n, origin) - plane.offset) / std::sqrt(dot(n, n));
}

/// Of the shapes that are made here: the distance from a keep-out, or how far a place is inside a keep-in.
Real room_of(const Fence& fence, const Point& p, const Point& origin) {
  Real most = -1e18L;
  Real square = 0;
  for (int k = 0; k < fence.count; ++k) {
    const Real out = beyond(fence.planes[k], p, origin);
    most = std::max(most, out);
    if (out > 0) square += out * out;
  }
  if (fence.kind == FenceKind::kKeepIn) return -most;
  return most > 0 ? std::sqrt(square) : most;
}

/// A piece of a plan without a joint inside: it stays within `bend` of the straight line between its ends.
struct Stretch {
  Point begin, end;
  Real bend;

  /// The least that it is beyond a plane, on one side (1) or the other (-1), can be.
  Real beyond_at_least(const Halfspace& plane, Real side, const Point& origin) const {
    return std::min(side * beyond(plane, begin, origin), side * beyond(plane, end, origin)) - bend;
  }
};

Stretch stretch_of(const tern::Trajectory& plan, const Interval& piece) {
  const Chain<tern::Segment> chain = chain_of(plan);
  const Real lasts = piece.end - piece.begin;
  return {chain.place(piece.begin), chain.place(piece.end), chain.most(2, piece.begin, piece.end) * lasts * lasts / 8};
}

struct Held {
  const tern::Request& request;
  const tern::Trajectory& plan;
  Real radius;

  /// The least room at a time that is no instant of change.
  Real room(Real t) const {
    const Point p = chain_of(plan).place(t);
    const Point origin = point(plan.origin);
    Real least = 1e18L;
    Real inside = -1e18L;
    bool has_keep_in = false;
    for (int k = 0; k < request.fence_count; ++k) {
      const Fence& fence = request.fences[k];
      if (!tern::is_timed(fence)) continue;
      const bool keeps_in = fence.kind == FenceKind::kKeepIn;
      has_keep_in = has_keep_in || keeps_in;
      if (t < window_begin(fence, plan) || t > window_end(fence, plan)) continue;
      const Real room = room_of(fence, p, origin);
      if (keeps_in) inside = std::max(inside, room);
      if (!keeps_in) least = std::min(least, room - radius);
    }
    return has_keep_in ? std::min(least, inside) : least;
  }

  /// True if a plane of a keep-out, or all planes of a keep-in, say that a stretch has room.
  bool plane_says_so(const Fence& fence, const Stretch& stretch, Real slack) const {
    const bool keeps_in = fence.kind == FenceKind::kKeepIn;
    int sure = 0;
    for (int i = 0; i < fence.count; ++i) {
      const Real room = stretch.beyond_at_least(fence.planes[i], keeps_in ? -1 : 1, point(plan.origin));
      sure += room >= (keeps_in ? -slack : radius - slack) ? 1 : 0;
    }
    return sure == fence.count || (!keeps_in && sure > 0);
  }

  /// True if planes say that there is room throughout a piece without an instant of change. This decides plans that
  /// slide along a plane, which the speed alone does not.
  bool planes_say_so(const Interval& piece, Real slack) const {
    const Stretch stretch = stretch_of(plan, piece);
    bool is_inside = false;
    bool has_keep_in = false;
    for (int k = 0; k < request.fence_count; ++k) {
      const Fence& fence = request.fences[k];
      if (!tern::is_timed(fence)) continue;
      const bool keeps_in = fence.kind == FenceKind::kKeepIn;
      has_keep_in = has_keep_in || keeps_in;
      if (piece.end < window_begin(fence, plan) || piece.begin > window_end(fence, plan)) continue;
      const bool says_so = plane_says_so(fence, stretch, slack);
      is_inside = is_inside || (keeps_in && says_so);
      if (!keeps_in && !says_so) return false;
    }
    return is_inside || !has_keep_in;
  }

  /// Whether there is room but for `slack` between two instants of change; if not, `when` gets the time.
  Proof holds_between(Real begin, Real end, Real slack, Real& when) const {
    Real joint = 0;
    for (int s = 0; s <= plan.count; ++s) {
      const Real next = s < plan.count ? joint + plan.segments[s].duration : end;
      const Real from = std::max(begin, joint);
      const Real to = std::min(end, next);
      const Proof proof = from < to ? holds(from, to, slack, when) : Proof::kProven;
      if (proof != Proof::kProven) return proof;
      joint = next;
    }
    return Proof::kProven;
  }

  /// The same without a joint between them.
  Proof holds(Real begin, Real end, Real slack, Real& when) const {
    const auto room_at = [&](Real t) { return room(t); };
    const auto is_sure = [&](const Interval& piece, Real found) {
      const Real lasts = piece.end - piece.begin;
      return found - chain_of(plan).most(1, piece.begin, piece.end) * lasts / 2 >= -slack ||
             planes_say_so(piece, slack);
    };
    return stays_above(-slack, {begin, end}, room_at, is_sure, when);
  }
};

}  // namespace

void TimedFences::add(Rng& rng, const World& world, tern::Request& request) {
  const tern::Vec3& from = request.start.position;
  const tern::Vec3& to = request.goal.position;
  const double size = std::max(1.0, 10.0 * world.spec.cell);
  fences.assign(request.fences, request.fences + request.fence_count);
  int used = 0;
  for (const Fence& fence : fences) used += fence.count;
  const bool has_keep_ins = rng.chance(0.4);
  const int wanted = rng.integer(1, 3);
  for (int k = 0; k < wanted; ++k) {
    const bool keeps_in = has_keep_ins && k > 0;
    const bool is_box = keeps_in || rng.chance(0.5);
    const int count = is_box ? tern::kBoxPlanes : rng.integer(1, 2);
    if (static_cast<int>(fences.size()) == tern::kMaxFences || used + count > tern::kMaxFencePlanes) break;
    used += count;
    std::vector<Halfspace>& of = planes.emplace_back(static_cast<std::size_t>(count));
    const double share = rng.real(-0.1, 1.1);
    tern::Vec3 at{};
    tern::Box box{};
    tern::Vec3 normal{rng.real(-1.0, 1.0), rng.real(-1.0, 1.0), rng.real(0.1, 1.0)};
    for (int a = 0; a < 3; ++a) {
      axis(at, a) = axis(from, a) + share * (axis(to, a) - axis(from, a)) + 0.3 * size * rng.real(-1.0, 1.0);
      const double half = (keeps_in ? 2.0 : 0.2) * size * rng.real(0.2, 1.0);
      axis(box.lower, a) = axis(at, a) - half;
      axis(box.upper, a) = axis(at, a) + half;
    }
    if (keeps_in && rng.chance(0.5)) {
      for (int a = 0; a < 3; ++a) {
        axis(box.lower, a) = std::min(axis(box.lower, a), std::min(axis(from, a), axis(to, a)) - 0.1);
        axis(box.upper, a) = std::max(axis(box.upper, a), std::max(axis(from, a), axis(to, a)) + 0.1);
      }
    }
    if (is_box) {
      Halfspace faces[tern::kBoxPlanes];
      tern::box_planes(box, faces);
      of.assign(faces, faces + tern::kBoxPlanes);
    }
    const double offset = normal.x * at.x + normal.y * at.y + normal.z * at.z;
    if (!is_box) of[0] = {normal, offset};
    if (!is_box && count == 2) of[1] = {{-normal.x, -normal.y, -normal.z}, 0.1 * size - offset};
    Fence fence{of.data(), count, keeps_in ? FenceKind::kKeepIn : FenceKind::kKeepOut};
    fence.from = request.begin + static_cast<std::int64_t>((keeps_in ? -5e9 : 0.0) + 8e9 * rng.real(-1.0, 1.0));
    fence.until = fence.from + static_cast<std::int64_t>(rng.spread(1e7, keeps_in ? 1e12 : 2e10));
    fence.clock_error = rng.chance(0.5) ? 0.0 : rng.real(0.0, 0.5);
    fences.push_back(fence);
  }
  request.fences = fences.data();
  request.fence_count = static_cast<std::int32_t>(fences.size());
}

void check_windows(const World& world, const tern::Request& request, const tern::Trajectory& plan, double until,
                   const char* what, Findings& findings) {
  constexpr Real kSlack = 1e-8L;  // a plan is granted 2 nm, and any other curve 4
  std::vector<Real> times{0, until * (1 - 1e-13L)};
  for (int k = 0; k < request.fence_count; ++k) {
    if (!tern::is_timed(request.fences[k])) continue;
    for (const Real time : {window_begin(request.fences[k], plan), window_end(request.fences[k], plan)}) {
      if (time > 0 && time < times[1]) times.push_back(time);
    }
  }
  std::sort(times.begin(), times.end());
  const Held held{request, plan, world.radius()};
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if (times[i] + 2 * kInstant >= times[i + 1] - 2 * kInstant) continue;
    Real when = 0;
    const Proof proof = held.holds_between(times[i] + kInstant, times[i + 1] - kInstant, kSlack, when);
    if (proof == Proof::kProven) continue;
    report(findings, proof == Proof::kBroken ? "window" : "window_unproven",
           "%s: %.3Lg m too far after %.9Lf s of %.9f", what, -held.room(when), when, until);
    return;
  }
}

}  // namespace tern_attack
