// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/programme.hpp"

#include "base/math.hpp"
#include "curve/motion_limits.hpp"
#include "tern/halfspace.hpp"
#include "trajectory/end_weights.hpp"
#include "trajectory/limit_planes.hpp"
#include "trajectory/piece.hpp"
#include "trajectory/programme_points.hpp"
#include "trajectory/thrust_planes.hpp"
#include "trajectory/turning_rows.hpp"

namespace tern {
namespace {

/// Stiffness of the springs at vias, relative to the Hessian's diagonal. Their part of the cost is below the solver's
/// tolerance.
constexpr double kSpring = 1e-10;

static_assert(kControlPoints + kVelocityPoints + kAccelerationPoints + kJerkPoints <= kQpPointsPerSegment,
              "room for a segment's points");

double mean_duration(const Chain& chain) {
  double sum = 0.0;
  for (int i = 0; i < chain.count; ++i) sum += chain.duration[i];
  return sum / chain.count;
}

/// Sets the scales of the joints, from the roots of the Hessian's diagonal. The two segments at a joint contribute to
/// it.
void scale_joints(const Chain& chain, ProgrammeScale& scale) {
  for (int i = 0; i + 1 < chain.count; ++i) {
    const double before = chain.duration[i] / scale.tau;
    const double after = chain.duration[i + 1] / scale.tau;
    double before_cost = kCostScale / seventh_power(before);
    double after_cost = kCostScale / seventh_power(after);
    for (int k = 0; k < kJointOrder; ++k) {
      scale.joint[i][k] = 1.0 / square_root(kSnapForm[k][k] * (before_cost + after_cost));
      before_cost *= before * before;
      after_cost *= after * after;
    }
  }
}

void add_linear(const Piece& piece, int row, int given, QpProblem& problem) {
  const double weight = piece.cost * kSnapForm[row][given] * piece.factor[row];
  for (int a = 0; a < kQpAxes; ++a) problem.linear[a][unknown_of(piece, row)] += weight * axis(piece.fixed[given], a);
}

void add_cost(const Piece& piece, QpProblem& problem) {
  for (int row = 0; row < kEnds; ++row) {
    if (!piece.free[row / kJointOrder]) continue;
    for (int column = 0; column < kEnds; ++column) {
      if (!piece.free[column / kJointOrder] || (piece.held && piece.given[column])) {
        add_linear(piece, row, column, problem);
      } else if (column <= row) {
        problem.hessian[unknown_of(piece, row)][row - column] +=
            piece.cost * kSnapForm[row][column] * (piece.factor[row] * piece.factor[column]);
      }
    }
  }
}

/// A weak spring from the joint to its via: without it the Hessian of a long chain is too nearly singular to be
/// factored.
void add_spring(const ViaJoint& via_joint, const Vec3& center, const ProgrammeScale& scale, QpProblem& problem) {
  const int unknown = kJointOrder * (via_joint.segment - 1);
  const Vec3 at = (kSpring / scale.joint[via_joint.segment - 1][0]) * (via_joint.position - center);
  problem.hessian[unknown][0] += kSpring;
  for (int a = 0; a < kQpAxes; ++a) problem.linear[a][unknown] -= axis(at, a);
}

/// At the joints of vias: gives a unit diagonal to unknowns whose derivatives are given, so that they stay 0, and adds
/// springs.
void add_via_joints(const Chain& chain, const ProgrammeScale& scale, QpProblem& problem) {
  for (int i = 0; i < chain.via_joint_count; ++i) {
    const ViaJoint& via_joint = chain.via_joints[i];
    for (int k = 0; k < kJointOrder; ++k) {
      if (gives(via_joint, k)) problem.hessian[kJointOrder * (via_joint.segment - 1) + k][0] = 1.0;
    }
    if (!gives(via_joint, 0)) add_spring(via_joint, chain.center, scale, problem);
  }
}

/// Adds the planes of a polyhedron, relative to the centre.
void add_polyhedron(const Polyhedron& polyhedron, const Vec3& center, QpProblem& problem) {
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    problem.planes[problem.plane_count] = Halfspace{plane.normal, plane.offset - dot(plane.normal, center)};
    ++problem.plane_count;
  }
}

PointOrigin origin_of(int segment, int order, int index) {
  return {static_cast<std::int16_t>(segment), static_cast<std::int8_t>(order), static_cast<std::int8_t>(index)};
}

void add_corridor(const Chain& chain, const Corridor& corridor, ProgrammeScale& scale, QpProblem& problem) {
  const EndWeightList points = end_weights_of(0);
  int plane_begin = 0;
  for (int i = 0; i < chain.count; ++i) {
    if (i == 0 || chain.polyhedron[i] != chain.polyhedron[i - 1]) {
      plane_begin = problem.plane_count;
      add_polyhedron(corridor.polyhedra[chain.polyhedron[i]], chain.center, problem);
    }
    const Piece piece = piece_of(chain, scale, i);
    const int point_begin = problem.point_count;
    for (int k = 0; k < kControlPoints; ++k) {
      add_point(piece, points.list[k], 1.0, origin_of(i, 0, k), scale, problem);
    }
    add_group(point_begin, plane_begin, problem.plane_count, problem);
  }
}

/// The boundary state towards which polygons and polyhedra turn a corner, where they lose nothing of the limit: the
/// programme cannot change that state.
Vec3 kept_state(const Chain& chain, int order) {
  return horizontal_length(chain.start.d[order]) > 0.0 ? chain.start.d[order] : chain.goal.d[order];
}

/// Adds the planes of the limits on one derivative, and returns their unit.
double add_limit_planes(const Bounds& bounds, const Vec3& along, int order, QpProblem& problem) {
  const LimitPlanes limit = limit_planes(bounds, along, order == 3 ? kJerkMargin : kConstraintMargin);
  for (const Halfspace* plane = limit.planes; plane != limit.planes + limit.count; ++plane) {
    problem.planes[problem.plane_count++] = *plane;
  }
  problem.plane_count += thrust_planes(bounds, along, limit.unit, problem.planes + problem.plane_count);
  return limit.unit;
}

/// Adds the points of one derivative, in the scale's unit, and a group for each segment unless there are no planes from
/// `plane_begin` on. All segments but the first leave out their first point: it is the last point of the segment
/// before.
void add_order_points(const Chain& chain, ProgrammeScale& scale, int order, int plane_begin, QpProblem& problem) {
  const EndWeightList points = end_weights_of(order);
  for (int i = 0; i < chain.count; ++i) {
    const Piece piece = piece_of(chain, scale, i);
    const double multiplier = 1.0 / (power_of(chain.duration[i], order) * scale.unit[order]);
    const int point_begin = problem.point_count;
    for (int r = i == 0 ? 0 : 1; r < points.count; ++r) {
      add_point(piece, points.list[r], multiplier, origin_of(i, order, r), scale, problem);
    }
    if (plane_begin < problem.plane_count) add_group(point_begin, plane_begin, problem.plane_count, problem);
  }
}

/// Adds the limit on one derivative to every segment.
void add_limit_constraints(const Chain& chain, ProgrammeScale& scale, const Bounds& bounds, int order,
                           QpProblem& problem) {
  const int plane_begin = problem.plane_count;
  scale.unit[order] = add_limit_planes(bounds, kept_state(chain, order), order, problem);
  add_order_points(chain, scale, order, plane_begin, problem);
}

/// Adds the constraints of the jerk, with those of body rates.
void add_jerk_constraints(const Chain& chain, const MotionLimits& limits, const Turning* turning, int accelerations,
                          ProgrammeScale& scale, QpProblem& problem) {
  const int jerks = problem.point_count;
  if (limits_anything(limits.jerk)) {
    add_limit_constraints(chain, scale, limits.jerk, 3, problem);
  } else if (limits.rate > 0.0) {
    scale.unit[3] = limits.rate * kGravity;
    add_order_points(chain, scale, 3, problem.plane_count, problem);
  }
  if (limits.rate > 0.0) add_turning_rows(*turning, chain.count, accelerations, jerks, scale, problem);
}

/// Adds the constraints that keep the joints at vias with a tolerance in their cubes.
void add_via_constraints(const Chain& chain, ProgrammeScale& scale, QpProblem& problem) {
  for (int i = 0; i < chain.via_joint_count; ++i) {
    const ViaJoint& via_joint = chain.via_joints[i];
    if (gives(via_joint, 0)) continue;
    const int point_begin = problem.point_count;
    const int plane_begin = problem.plane_count;
    const Vec3 edge{via_joint.reach, via_joint.reach, via_joint.reach};
    const Vec3 at = via_joint.position - chain.center;
    Halfspace faces[kBoxPlanes];
    box_planes({at - edge, at + edge}, faces);
    for (const Halfspace& face : faces) problem.planes[problem.plane_count++] = face;
    add_point(piece_of(chain, scale, via_joint.segment), end_weights_of(0).list[0], 1.0,
              origin_of(via_joint.segment, 0, 0), scale, problem);
    add_group(point_begin, plane_begin, problem.plane_count, problem);
  }
}

void clear(int unknowns, QpProblem& problem) {
  problem.unknowns = unknowns;
  problem.point_count = 0;
  problem.plane_count = 0;
  problem.group_count = 0;
  for (int i = 0; i < unknowns; ++i) {
    for (int d = 0; d <= kQpBand; ++d) problem.hessian[i][d] = 0.0;
    for (int a = 0; a < kQpAxes; ++a) problem.linear[a][i] = 0.0;
  }
}

}  // namespace

void assemble(const Chain& chain, const Corridor& corridor, const MotionLimits& limits, const Turning* turning,
              QpProblem& problem, ProgrammeScale& scale) noexcept {
  clear(kJointOrder * (chain.count - 1), problem);
  scale.tau = mean_duration(chain);
  scale.unit[0] = 1.0;
  scale.snap_per_cost = 2.0 / (kCostScale * seventh_power(scale.tau));
  scale_joints(chain, scale);
  for (int i = 0; i < chain.count; ++i) add_cost(piece_of(chain, scale, i), problem);
  add_via_joints(chain, scale, problem);
  add_corridor(chain, corridor, scale, problem);
  add_limit_constraints(chain, scale, limits.velocity, 1, problem);
  const int accelerations = problem.point_count;
  add_limit_constraints(chain, scale, limits.acceleration, 2, problem);
  add_jerk_constraints(chain, limits, turning, accelerations, scale, problem);
  add_via_constraints(chain, scale, problem);
}

}  // namespace tern
