// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/chain_ends.hpp"

#include "base/bounds.hpp"
#include "curve/motion_limits.hpp"
#include "trajectory/hodograph_points.hpp"

namespace tern {
namespace {

/// An end's duration is multiplied by kEndStep at most this many times, which makes it 1e5 times shorter.
constexpr int kEndTries = 52;
constexpr double kEndStep = 0.8;

/// Shortest segment after even_out(), in parts of the mean.
constexpr double kShortestPart = 1.0 / 16.0;

bool moves(const JointState& state) {
  return dot(state.d[1], state.d[1]) > 0.0 || dot(state.d[2], state.d[2]) > 0.0 || dot(state.d[3], state.d[3]) > 0.0;
}

/// True if the points that depend on the first four control points alone keep the limit.
bool fixed_points_hold(int order, const Vec3* points, double duration, const Bounds& bounds) {
  const OrderPoints points_of_order = points_of(order);
  const double scale = 1.0 / power_of(duration, order);
  for (int r = 0; r < points_of_order.count; ++r) {
    const double* const weights = points_of_order.weights[r];
    Vec3 value = kZero;
    bool fixed = true;
    for (int k = 0; k < kControlPoints; ++k) {
      if (k < kJointOrder) value = value + (scale * weights[k]) * (points[k] - points[0]);
      if (k >= kJointOrder && (weights[k] < 0.0 || weights[k] > 0.0)) fixed = false;
    }
    if (fixed && gauge(bounds, value) > 1.0 + kLimitTolerance) return false;
  }
  return true;
}

bool end_holds(const JointState& end, const Polyhedron& polyhedron, const MotionLimits& limits, double duration) {
  Segment segment{};
  control_points(end, end, duration, segment.points);
  for (int k = kJointOrder; k <= kDegree; ++k) segment.points[k] = end.d[0];
  return inside(segment, polyhedron) && fixed_points_hold(1, segment.points, duration, limits.velocity) &&
         fixed_points_hold(2, segment.points, duration, limits.acceleration) &&
         fixed_points_hold(3, segment.points, duration, limits.jerk);
}

double fitting_duration(const JointState& end, const Polyhedron& polyhedron, const MotionLimits& limits,
                        double duration, int& tries) {
  if (!moves(end)) return duration;
  for (int i = 0; i < kEndTries && duration > kMinDuration; ++i) {
    ++tries;
    if (end_holds(end, polyhedron, limits, duration)) return duration;
    duration *= kEndStep;
  }
  return larger(duration, kMinDuration);
}

/// Shortens a segment that leaves a point with a given velocity until the control point that follows from both is in
/// the polyhedron.
double fitting_lead(const Vec3& from, const Vec3& velocity, const Polyhedron& polyhedron, double duration, int& tries) {
  Segment segment{};
  for (Vec3& point : segment.points) point = from;
  for (int i = 0; i < kEndTries && duration > kMinDuration; ++i) {
    ++tries;
    segment.points[1] = from + (duration / kDegree) * velocity;
    if (inside(segment, polyhedron)) return duration;
    duration *= kEndStep;
  }
  return larger(duration, kMinDuration);
}

bool goes_from_rest_to_rest(const Segment& segment) {
  for (int k = 1; k < kJointOrder; ++k) {
    if (distance(segment.points[0], segment.points[k]) > 0.0) return false;
    if (distance(segment.points[kDegree], segment.points[kDegree - k]) > 0.0) return false;
  }
  return true;
}

/// The state flown backwards in time.
JointState backwards(const JointState& state) {
  return JointState{{state.d[0], kZero - state.d[1], state.d[2], kZero - state.d[3]}};
}

void fit_via_joint(const Corridor& corridor, const ViaJoint& via_joint, Chain& chain, int& tries) {
  if (!via_joint.has_velocity) return;
  const Vec3 before = kZero - via_joint.velocity;
  double* const duration = chain.duration + via_joint.segment;
  duration[0] = fitting_lead(via_joint.position, via_joint.velocity, corridor.polyhedra[via_joint.polyhedron],
                             duration[0], tries);
  duration[-1] =
      fitting_lead(via_joint.position, before, corridor.polyhedra[via_joint.polyhedron - 1], duration[-1], tries);
}

}  // namespace

int fit_ends(const Corridor& corridor, const MotionLimits& limits, Chain& chain) noexcept {
  const int last = chain.count - 1;
  int tries = 0;
  chain.duration[0] = fitting_duration(chain.start, corridor.polyhedra[0], limits, chain.duration[0], tries);
  chain.duration[last] = fitting_duration(backwards(chain.goal), corridor.polyhedra[corridor.count - 1],
                                          backwards(limits), chain.duration[last], tries);
  for (int i = 0; i < chain.via_joint_count; ++i) fit_via_joint(corridor, chain.via_joints[i], chain, tries);
  return tries;
}

void even_out(Chain& chain) noexcept {
  const double least = kShortestPart * chain_duration(chain) / chain.count;
  for (int i = 0; i < chain.count; ++i) chain.duration[i] = larger(chain.duration[i], least);
}

void follow(const Trajectory& plan, Chain& chain) noexcept {
  const int most = 2 * plan.count <= kMaxSegments ? 2 : 1;
  chain.count = 0;
  for (int i = 0; i < plan.count; ++i) {
    const Segment& segment = plan.segments[i];
    const int pieces = goes_from_rest_to_rest(segment) ? most : 1;
    const double length = distance(segment.points[0], segment.points[kDegree]) / pieces;
    append_pieces(length, segment.polyhedron, pieces, chain);
    for (int k = 1; k <= pieces; ++k) chain.duration[chain.count - k] = larger(kMinDuration, segment.duration / pieces);
  }
}

}  // namespace tern
