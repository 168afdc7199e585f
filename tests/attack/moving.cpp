// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move, in the world of a case: plans among them keep clear of each, by a checker of its own. It looks at
// instants, and proves what lies between by how fast everything moves.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "attack/attack_case.hpp"
#include "attack/in_time.hpp"
#include "attack/windows.hpp"

namespace tern_attack {
namespace {

using tern::Status;
using tern::Track;
using tern::TrackEnd;
using tern::TrackShape;

constexpr int kMostThings = 6;

Real seconds(std::int64_t from, std::int64_t to) {
  return (static_cast<Real>(to) - static_cast<Real>(from)) * 1e-9L;
}

Real apart(const Track& track, const Point& p) {
  if (track.shape == TrackShape::kBall) return std::sqrt(dot(p, p)) - track.radius;
  const Real up = std::max<Real>(0, std::fabs(p[2]) - track.half.z);
  if (track.shape == TrackShape::kCylinder) {
    return std::hypot(std::max<Real>(0, std::hypot(p[0], p[1]) - track.radius), up);
  }
  const Real x = std::max<Real>(0, std::fabs(p[0]) - track.half.x);
  return std::hypot(std::hypot(x, std::max<Real>(0, std::fabs(p[1]) - track.half.y)), up);
}

/// A trajectory beside a thing. Times are seconds since the beginning of the plan.
struct Pair {
  const tern::Trajectory& plan;
  const Track& track;
  Real radius;

  Real since(Real t) const { return seconds(track.measured, plan.begin) + t; }

  /// When the thing is there, until `end`: from its measurement on, and not after it is gone.
  Interval present(Real end) const {
    const Real gone = track.end == TrackEnd::kGone ? seconds(plan.begin, track.until) : end;
    return {std::max<Real>(0, seconds(plan.begin, track.measured)), std::min(end, gone)};
  }

  Real gap(Real t) const { return std::max(gap_as_expected(t), gap_in_reach(t)); }

  /// How far the thing is known at an age: it may rest, or do as it likes, after some time.
  Real known(Real age) const {
    return track.end == TrackEnd::kGoesOn ? age : std::min(age, seconds(track.measured, track.until));
  }

  /// How much more than is needed they are apart, by where the thing is expected.
  Real gap_as_expected(Real t) const {
    const Real age = since(t);
    const Real it = known(age);
    Point place = it * point(track.velocity);
    if (track.piece_count > 0) place = its().place(it);
    const Real growth = track.end == TrackEnd::kReach ? track.reach * (age - it) : 0;
    const Real error = track.error + it * (track.error_speed + track.error_growth * it / 2) + growth;
    return apart(track, chain_of(plan).place(t) - offset() - place) - error - radius;
  }

  /// The same by what it can reach since its measurement; nothing known where it has no such bound.
  Real gap_in_reach(Real t) const {
    if (track.reach <= 0.0) return -1e18L;
    const Point first = track.piece_count > 0 ? point(track.pieces[0].points[0]) : point({0.0, 0.0, 0.0});
    return apart(track, chain_of(plan).place(t) - offset() - first) - track.error - track.reach * since(t) - radius;
  }

  /// The most by which the first gap changes in a second of `part`.
  Real change_as_expected(const Interval& part) const {
    const Chain<tern::Segment> own = chain_of(plan);
    const Real fastest = own.most(1, part.begin, part.end);
    const Real growth = track.end == TrackEnd::kReach ? static_cast<Real>(track.reach) : 0;
    const Real from = since(part.begin);
    const Real to = since(part.end);
    if (known(from) < from) return fastest + growth;
    const Real errors = growth + track.error_speed + track.error_growth * std::max<Real>(0, known(to));
    if (track.piece_count == 0) return fastest + length(point(track.velocity)) + errors;
    const Real sum = fastest + its().most(1, from, to);
    const bool turns_on = own.lasts_until(part.end) && its().lasts_until(to) && known(to) >= to;
    if (!turns_on) return sum + errors;
    // Where one follows the other, their velocities are nearly equal.
    const Real middle = (part.begin + part.end) / 2;
    const Real parting = length(own.velocity(middle) - its().velocity(since(middle))) +
                         (own.most(2, part.begin, part.end) + its().most(2, from, to)) * (part.end - part.begin) / 2;
    return std::min(sum, parting) + errors;
  }

 private:
  Chain<tern::TrackPiece> its() const { return {track.pieces, track.piece_count}; }
  Point offset() const { return point(track.position) - point(plan.origin); }
};

/// Whether the gap stays above -`slack` until `end`; if not, or if that is unproven, `when` gets the time.
Proof stays_clear(const Pair& pair, Real end, Real slack, Real& when) {
  const Interval there = pair.present(end);
  if (there.begin > there.end) return Proof::kProven;
  const auto gap_at = [&](Real t) { return pair.gap(t); };
  const auto is_sure = [&](const Interval& piece, Real) {
    const Real half = (piece.end - piece.begin) / 2;
    const Real middle = piece.begin + half;
    const Real in_reach = chain_of(pair.plan).most(1, piece.begin, piece.end) + pair.track.reach;
    return pair.gap_as_expected(middle) - pair.change_as_expected(piece) * half >= -slack ||
           pair.gap_in_reach(middle) - in_reach * half >= -slack;
  };
  return stays_above(-slack, there, gap_at, is_sure, when);
}

Track make_thing(Rng& rng, const World& world, const Ask& ask) {
  const tern::Vec3& from = ask.request.start.position;
  const tern::Vec3& to = ask.request.goal.position;
  const double size = std::max(1.0, 10.0 * world.spec.cell);
  const double share = rng.real(-0.1, 1.1);
  Track track;
  for (int a = 0; a < 3; ++a) {
    axis(track.velocity, a) = rng.chance(0.2) ? 0.0 : rng.real(-1.0, 1.0) * size * 0.3;
    axis(track.position, a) = axis(from, a) + share * (axis(to, a) - axis(from, a)) + 0.5 * size * rng.real(-1.0, 1.0);
    axis(track.half, a) = 0.1 * size * rng.unit();
  }
  const double age = rng.chance(0.1) ? rng.spread(10.0, 1e6) : rng.real(-2.0, 5.0);
  track.measured = ask.request.begin - static_cast<std::int64_t>(age * 1e9);
  track.until = std::max(track.measured, ask.request.begin) + static_cast<std::int64_t>(rng.real(0.0, 2e10));
  track.shape = static_cast<TrackShape>(rng.integer(0, 2));
  track.end = static_cast<TrackEnd>(rng.integer(0, 3));
  track.radius = 0.1 * size * rng.unit();
  track.error = rng.chance(0.5) ? 0.0 : 0.05 * size * rng.unit();
  track.error_speed = rng.chance(0.5) || age > 10.0 ? 0.0 : 0.02 * size * rng.unit();
  track.error_growth = rng.chance(0.7) || age > 10.0 ? 0.0 : 0.05 * size * rng.unit();
  track.reach = rng.chance(0.8) ? 0.0 : 0.3 * size * rng.unit();
  return track;
}

/// For kLeaveTime, a plan that leaves a thing comes no nearer to its curve, whatever the error, unless it is clear of
/// all that the thing may do: at a thousand instants. A thing whose reach is shorter than its curve may be anywhere
/// else.
void check_leaving(const Pair& tube, double until, const char* what, Findings& findings) {
  constexpr Real kLeaveTime = 1.0L;  // docs/tracks.md
  constexpr Real kLeaveSlack = 1e-6L;
  constexpr int kInstants = 1000;
  Track thing = tube.track;
  thing.error = thing.error_speed = thing.error_growth = thing.reach = 0.0;
  const Pair pair{tube.plan, thing, 0};
  const Real end = std::min<Real>(kLeaveTime, pair.present(until).end);
  const Real begun = pair.gap(0);
  for (int n = 1; n <= kInstants; ++n) {
    const Real t = end * n / kInstants;
    if (pair.gap(t) >= begun - kLeaveSlack || tube.gap(t) >= 0) continue;
    return report(findings, "track", "%s: %.3Lg m nearer after %.3Lf s", what, begun - pair.gap(t), t);
  }
}

}  // namespace

void check_tracks(const World& world, const tern::Request& request, const tern::Trajectory& plan, double until,
                  bool may_leave, const char* what, Findings& findings) {
  constexpr Real kSlack = 1e-8L;  // a plan is granted 2 nm, and any other curve 4
  for (int k = 0; k < request.track_count && until > 0.0; ++k) {
    const Track& thing = request.tracks[k];
    const Pair pair{plan, thing, world.radius()};
    if (may_leave && pair.present(until).begin <= 0 && pair.gap(0) < -kSlack) {
      check_leaving(pair, until, what, findings);
      continue;
    }
    Real when = 0;
    const Proof proof = stays_clear(pair, until * (1 - 1e-13L), kSlack, when);
    if (proof == Proof::kProven) continue;
    report(findings, proof == Proof::kBroken ? "track" : "track_unproven",
           "%s: %.3Lg m too near to track %d after %.9Lf s of %.9f", what, -pair.gap(when), k, when, until);
  }
}

void attack_tracks(Context& context, Rng& own, tern::Planner& planner, const World& world, const Ask& ask,
                   Status without) {
  tern::Trajectory& out = context.bench.trajectory;
  tern::Request request = ask.request;
  Track things[kMostThings];
  tern::TrackPiece pieces[tern::kMaxSegments];
  const int count = own.integer(1, kMostThings);
  request.begin = static_cast<std::int64_t>(own.spread(1.0, 1e18));
  Ask dated;
  dated.request = request;
  for (int k = 0; k < count; ++k) things[k] = make_thing(own, world, dated);
  if (without == Status::kOk && own.chance(0.3)) {
    tern::Trajectory other = out;
    other.begin = request.begin + static_cast<std::int64_t>(own.real(-2e9, 2e9));
    other.origin.z += own.real(-0.5, 0.5);
    tern::track_of(other, 0.2, pieces, tern::kMaxSegments, things[0]);
  }
  request.tracks = things;
  request.track_count = count;
  request.rest_clear = own.chance(0.5) ? 0.0 : own.real(0.0, 5.0);
  request.previous = nullptr;
  TimedFences windows;
  if (own.chance(0.4)) windows.add(own, world, request);
  if (without == Status::kOk) {
    out.begin = request.begin;
    tern::TrackGrounds grounds;
    grounds.tracks = things;
    grounds.count = count;
    grounds.radius = static_cast<double>(world.radius());
    grounds.fences = request.fences;
    grounds.fence_count = request.fence_count;
    const double until = tern::clear_until(out, 0.0, grounds);
    check_tracks(world, request, out, until, false, "proof", context.findings);
    check_windows(world, request, out, until, "proof", context.findings);
  }
  tern::Report answer;
  spoil(out);
  const Status status = planner.plan(world.grid, request, out, answer);
  ++context.tally.plans;
  ++context.tally.status[static_cast<int>(status)];
  if (context.verbose) std::printf("among %d things: %s\n", count, tern::status_name(status));
  if (status == Status::kCheckFailed || status == Status::kInvalidArgument) {
    return report(context.findings, "track", "%s", tern::status_name(status));
  }
  if (status != Status::kOk) {
    if (!spoiled(out))
      report(context.findings, "touched", "tracks: the output changed with %s", tern::status_name(status));
    if (without == Status::kNoPath && status != without && !is_capacity(status)) {
      report(context.findings, "track", "%s, and no_path without tracks", tern::status_name(status));
    }
    return;
  }
  check_plan(context.rng, world, request, out, 0.0, context.findings);
  check_vias(world, request, out, answer, context.findings);
  const double end = tern::duration(out);
  check_tracks(world, request, out, end + request.rest_clear, true, "plan", context.findings);
  check_windows(world, request, out, end + request.rest_clear, "plan", context.findings);
  const double rest = std::min(answer.rest_clear_until, end + 100.0);
  if (rest < end) report(context.findings, "track", "rest_clear_until %.9g before the end, %.9g", rest, end);
  check_tracks(world, request, out, rest, true, "rest", context.findings);
  check_windows(world, request, out, rest, "rest", context.findings);
}

}  // namespace tern_attack
