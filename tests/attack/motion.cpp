// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The checker's rules on derivatives: limits for all t, joints, ends, and what evaluate() says of them.
#include <limits>

#include "attack/checker.hpp"

namespace tern_attack {
namespace {

/// Largest and least of each axis, and the horizontal norm, 0 for none.
struct Allowed {
  Point most;
  Point least;
  Real horizontal;
};

Allowed allowed(const tern::Vec3& most, const tern::Vec3& least, double horizontal, Real excess) {
  Allowed result{};
  for (int a = 0; a < 3; ++a) {
    const Real down = axis(least, a) < 0.0 ? axis(least, a) : -axis(most, a);
    result.most[a] = axis(most, a) * (1 + kLimitSlack) + excess;
    result.least[a] = down * (1 + kLimitSlack) - excess;
  }
  result.horizontal = horizontal > 0.0 ? horizontal * (1 + kLimitSlack) + 2 * excess : 0;
  return result;
}

bool holds(const Allowed& limit, const Point& v) {
  for (int a = 0; a < 3; ++a) {
    if (v[a] > limit.most[a] || v[a] < limit.least[a]) return false;
  }
  return limit.horizontal <= 0 || v[0] * v[0] + v[1] * v[1] <= limit.horizontal * limit.horizontal;
}

/// An axis of 0 has no limit.
Allowed allowed_jerk(const tern::Limits& limits, Real excess) {
  Allowed result = allowed(limits.j_max, {0, 0, 0}, limits.j_horizontal, excess);
  for (int a = 0; a < 3; ++a) {
    if (axis(limits.j_max, a) > 0.0) continue;
    result.most[a] = std::numeric_limits<Real>::infinity();
    result.least[a] = -result.most[a];
  }
  return result;
}

void check_derivative(const Curve& curve, const Allowed& limit, const char* kind, int s, Findings& findings) {
  const Verdict verdict = prove(curve, [&](const Point& v) { return holds(limit, v); });
  if (verdict.proof == Proof::kProven) return;
  const Point v = value(curve, verdict.where);
  report(findings, kind, "segment %d u %.17Lg: (%.17Lg, %.17Lg, %.17Lg)%s", s, verdict.where, v[0], v[1], v[2],
         verdict.proof == Proof::kUnproven ? ", not decided" : "");
}

/// Position to snap.
struct Jet {
  Point d[5];
};

Jet jet(const tern::Segment& segment, Real u) {
  Jet result{};
  Curve curve = curve_of(segment.points);
  for (Point& d : result.d) {
    d = value(curve, u);
    curve = derivative(curve, segment.duration);
  }
  return result;
}

constexpr const char* kOrders[] = {"position", "velocity", "acceleration", "jerk", "snap"};

/// Positions are the same bits; a derivative is as good as its control points.
Real slack_of(const tern::Segment& segment, int order) {
  return order == 0 ? 0 : kPointUlps * rounding(segment, order);
}

}  // namespace

void check_limits(const tern::Request& request, const tern::Trajectory& trajectory, Findings& findings) {
  const tern::Limits& limits = request.limits;
  const std::size_t before = findings.size();
  for (int s = 0; s < trajectory.count && findings.size() == before; ++s) {
    const tern::Segment& segment = trajectory.segments[s];
    const Curve velocity = derivative(curve_of(segment.points), segment.duration);
    const Curve acceleration = derivative(velocity, segment.duration);
    const Real v = kLimitUlps * rounding(segment, 1);
    const Real a = kLimitUlps * rounding(segment, 2);
    check_derivative(velocity, allowed(limits.v_max, limits.v_min, limits.v_horizontal, v), "velocity", s, findings);
    check_derivative(acceleration, allowed(limits.a_max, limits.a_min, limits.a_horizontal, a), "acceleration", s,
                     findings);
    const Curve jerk = derivative(acceleration, segment.duration);
    check_derivative(jerk, allowed_jerk(limits, kLimitUlps * rounding(segment, 3)), "jerk", s, findings);
  }
}

void check_joints(const tern::Trajectory& trajectory, Findings& findings) {
  for (int s = 1; s < trajectory.count; ++s) {
    const tern::Segment& before = trajectory.segments[s - 1];
    const tern::Segment& after = trajectory.segments[s];
    const Jet left = jet(before, 1);
    const Jet right = jet(after, 0);
    for (int k = 0; k < 4; ++k) {
      const Real gap = largest(left.d[k] - right.d[k]);
      const Real slack = slack_of(before, k) + slack_of(after, k);
      if (gap <= slack) continue;
      return report(findings, "joint", "%s between segments %d and %d by %.6Lg, allowed %.6Lg", kOrders[k], s - 1, s,
                    gap, slack);
    }
  }
}

namespace {

void check_end(const World& world, const tern::State& state, const tern::Segment& segment, double u,
               const Point& origin, const Point& other_jerk, const char* kind, Findings& findings) {
  const Jet end = jet(segment, u);
  const Point asked[] = {point(state.position) - origin, point(state.velocity), point(state.acceleration)};
  // World coordinates have the rounding of their own size; a point on the boundary's face may be moved onto it.
  const Real own = 4 * kUlp * largest(point(state.position)) + 4 * kUlp * largest(point(world.spec.origin));
  const Real face = 1e-9L * world.spec.cell;
  // Within a segment, the position that is asked for was rounded by evaluate().
  const Real place = own + face + (u > 0.0 && u < 1.0 ? 8 * rounding(segment, 0) : 0);
  for (int k = 0; k < 3; ++k) {
    const Real gap = largest(end.d[k] - asked[k]);
    const Real slack = slack_of(segment, k) + (k == 0 ? place : 0);
    if (gap > slack) return report(findings, kind, "%s by %.6Lg, allowed %.6Lg", kOrders[k], gap, slack);
  }
  const Real jerk = std::min(largest(end.d[3] - point(state.jerk)), largest(end.d[3] - other_jerk));
  if (jerk > slack_of(segment, 3)) report(findings, kind, "jerk %.6Lg", jerk);
}

}  // namespace

void check_ends(const World& world, const tern::Request& request, const tern::Trajectory& trajectory, double entered,
                Findings& findings) {
  double begin = 0.0;
  int first = 0;
  while (first + 1 < trajectory.count && entered >= begin + trajectory.segments[first].duration)
    begin += trajectory.segments[first++].duration;
  const double u = std::min(1.0, (entered - begin) / trajectory.segments[first].duration);
  const Point origin = point(trajectory.origin);
  // A plan begins with the jerk that was asked for, or goes on with that of the previous one.
  const bool goes_on = request.previous != nullptr;
  const tern::Vec3 other = goes_on ? tern::evaluate(*request.previous, request.previous_time).jerk : request.start.jerk;
  check_end(world, request.start, trajectory.segments[first], u, origin, point(other), "start_state", findings);
  check_end(world, request.goal, trajectory.segments[trajectory.count - 1], 1, origin, point(request.goal.jerk),
            "goal_state", findings);
}

namespace {

/// The segment that begins at that time, or the number of segments at the plan's end; -1 where none does.
int joint_at(const tern::Trajectory& trajectory, double time) {
  double begin = 0.0;
  for (int s = 0; s < trajectory.count; ++s) {
    if (begin == time) return s;
    begin += trajectory.segments[s].duration;
  }
  return begin == time ? trajectory.count : -1;
}

/// Why a plan does not pass a via there; null where it does.
const char* miss(const World& world, const tern::Via& via, const tern::Segment& segment, Real u, const Point& origin) {
  const Jet state = jet(segment, u);
  const Point gap = state.d[0] - (point(via.position) - origin);
  const Real own = 4 * kUlp * (largest(point(via.position)) + largest(point(world.spec.origin)));
  if (length(gap) > via.tolerance + contact_slack(world) + own) return "too far away";
  if (!via.stop && !via.has_velocity) return nullptr;
  const Point velocity = via.has_velocity ? point(via.velocity) : Point{{0, 0, 0}};
  for (int k = 1; k <= (via.stop ? 3 : 1); ++k) {
    const Point wanted = k == 1 ? velocity : Point{{0, 0, 0}};
    if (largest(state.d[k] - wanted) > slack_of(segment, k)) return kOrders[k];
  }
  return nullptr;
}

/// True where the plan stays where it is for the via's dwell from that joint on.
bool dwells(const tern::Trajectory& trajectory, int joint, const tern::Via& via) {
  double rested = 0.0;
  for (int s = joint; s < trajectory.count; ++s) {
    const tern::Segment& segment = trajectory.segments[s];
    for (const tern::Vec3& p : segment.points) {
      if (largest(point(p) - point(segment.points[0])) > 0) return rested >= via.dwell;
    }
    rested += segment.duration;
  }
  return rested >= via.dwell;
}

}  // namespace

void check_vias(const World& world, const tern::Request& request, const tern::Trajectory& trajectory,
                const tern::Report& answer, Findings& findings) {
  double last = 0.0;
  for (int v = 0; v < request.via_count; ++v) {
    const tern::ViaPassage& passage = answer.vias[v];
    const int joint = joint_at(trajectory, passage.time);
    if (joint < 0 || passage.time < last) return report(findings, "via", "via %d at %.17g s", v, passage.time);
    const bool at_end = joint == trajectory.count;
    const tern::Segment& segment = trajectory.segments[at_end ? joint - 1 : joint];
    const char* const why = miss(world, request.vias[v], segment, at_end ? 1 : 0, point(trajectory.origin));
    if (!dwells(trajectory, joint, request.vias[v])) return report(findings, "via", "via %d: no dwell", v);
    if (why != nullptr) return report(findings, "via", "via %d: %s, %.17g m", v, why, passage.distance);
    last = passage.time;
  }
}

namespace {

/// The sample at a time within the trajectory against de Casteljau in long double.
void check_sample(const World& world, const tern::Trajectory& trajectory, double t, Findings& findings) {
  double begin = 0.0;
  int s = 0;
  while (s + 1 < trajectory.count && t >= begin + trajectory.segments[s].duration)
    begin += trajectory.segments[s++].duration;
  const tern::Segment& segment = trajectory.segments[s];
  const Real u = std::min(1.0L, (static_cast<Real>(t) - begin) / static_cast<Real>(segment.duration));
  const tern::Sample sample = tern::evaluate(trajectory, t);
  const Point said[] = {point(sample.position) - point(trajectory.origin), point(sample.velocity),
                        point(sample.acceleration), point(sample.jerk), point(sample.snap)};
  Curve curve = curve_of(segment.points);
  const Real late = 16 * kUlp * (t + segment.duration);
  for (int k = 0; k < 5; ++k) {
    const Curve next = derivative(curve, segment.duration);
    const Real own = k == 0 ? 4 * kUlp * (largest(point(sample.position)) + largest(point(world.spec.origin))) : 0;
    const Real slack = 1e-12L * magnitude(curve) * (k > 0) + 8 * rounding(segment, k) + late * magnitude(next) + own;
    const Real gap = largest(said[k] - value(curve, u));
    if (!(gap <= slack))
      return report(findings, "evaluate", "%s at t %.17g by %.6Lg, allowed %.6Lg", kOrders[k], t, gap, slack);
    curve = next;
  }
}

bool same(const tern::Vec3& a, const tern::Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool at_rest(const tern::Sample& s) {
  const tern::Vec3 zero{0.0, 0.0, 0.0};
  return same(s.velocity, zero) && same(s.acceleration, zero) && same(s.jerk, zero) && same(s.snap, zero);
}

void check_hold(const tern::Trajectory& trajectory, double t, Findings& findings) {
  const tern::Vec3& last = trajectory.segments[trajectory.count - 1].points[tern::kDegree];
  const tern::Vec3& o = trajectory.origin;
  const tern::Sample sample = tern::evaluate(trajectory, t);
  const bool there = same(sample.position, {o.x + last.x, o.y + last.y, o.z + last.z});
  if (!there || !at_rest(sample)) report(findings, "hold", "not at the goal, or not at rest, at t %.17g", t);
}

}  // namespace

void check_evaluate(Rng& rng, const World& world, const tern::Trajectory& trajectory, int samples, Findings& findings) {
  const std::size_t before = findings.size();
  const double end = tern::duration(trajectory);
  for (int k = 0; k < samples && findings.size() == before; ++k) {
    const double t = end * rng.unit();
    if (t < end) check_sample(world, trajectory, t, findings);
  }
  double joint = 0.0;
  for (int s = 0; s + 1 < trajectory.count && findings.size() == before; ++s) {
    joint += trajectory.segments[s].duration;
    check_sample(world, trajectory, joint, findings);
  }
  check_hold(trajectory, end, findings);
  check_hold(trajectory, end * 2.0 + 1.0, findings);
  check_hold(trajectory, std::numeric_limits<double>::infinity(), findings);
  const tern::Sample start = tern::evaluate(trajectory, 0.0);
  for (const double t : {-1.0, std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    const tern::Sample early = tern::evaluate(trajectory, t);
    if (!same(early.position, start.position) || !same(early.velocity, start.velocity)) {
      report(findings, "evaluate", "before the start it is not the start, t %g", t);
    }
  }
}

}  // namespace tern_attack
