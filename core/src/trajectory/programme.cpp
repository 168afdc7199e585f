// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/programme.hpp"

#include "base/math.hpp"
#include "curve/motion_limits.hpp"
#include "trajectory/hodograph_rows.hpp"
#include "trajectory/limit_planes.hpp"

namespace tern {
namespace {

/// Brings the scaled Hessian's unknowns to metres or so; of no influence on the minimum.
constexpr double kCostScale = 1e-5;
constexpr int kEnds = 2 * kJointOrder;

static_assert(kControlPoints + kVelocityRows + kAccelerationRows + kJerkRows <= kQpPointsPerSegment,
              "room for a segment's points");

/// One segment as the programme sees it.
struct Piece {
  int index;
  double t;              ///< duration over the mean
  double cost;           ///< kCostScale / t^7
  bool free[2];          ///< whether its first and second end are unknown
  double factor[kEnds];  ///< normalised derivative = factor * unknown, of free ends
  Vec3 fixed[kEnds];     ///< normalised derivative of ends that are given
};

double mean_duration(const Chain& chain) {
  double sum = 0.0;
  for (int i = 0; i < chain.count; ++i) sum += chain.duration[i];
  return sum / chain.count;
}

/// Roots of the Hessian's diagonal: what the two segments at a joint add to it.
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

void fix_end(const JointState& state, const Vec3& center, double duration, Vec3* fixed) {
  fixed[0] = state.d[0] - center;
  double power = duration;
  for (int k = 1; k < kJointOrder; ++k) {
    fixed[k] = power * state.d[k];
    power *= duration;
  }
}

void free_end(const double* joint, double t, double* factor) {
  double power = 1.0;
  for (int k = 0; k < kJointOrder; ++k) {
    factor[k] = power * joint[k];
    power *= t;
  }
}

Piece piece_of(const Chain& chain, const ProgrammeScale& scale, int index) {
  Piece piece{};
  piece.index = index;
  piece.t = chain.duration[index] / scale.tau;
  piece.cost = kCostScale / seventh_power(piece.t);
  piece.free[0] = index > 0;
  piece.free[1] = index + 1 < chain.count;
  for (int end = 0; end < 2; ++end) {
    const int at = end * kJointOrder;
    if (piece.free[end]) {
      free_end(scale.joint[index - 1 + end], piece.t, piece.factor + at);
    } else {
      fix_end(end == 0 ? chain.start : chain.goal, chain.center, chain.duration[index], piece.fixed + at);
    }
  }
  return piece;
}

/// The unknown that derivative e (of both ends, 0 .. 7) of a piece is, per axis.
int unknown_of(const Piece& piece, int e) {
  return kJointOrder * (piece.index - 1) + e;
}

void add_linear(const Piece& piece, int row, int given, QpProblem& problem) {
  const double weight = piece.cost * kSnapForm[row][given] * piece.factor[row];
  for (int a = 0; a < kQpAxes; ++a) problem.linear[a][unknown_of(piece, row)] += weight * axis(piece.fixed[given], a);
}

void add_cost(const Piece& piece, QpProblem& problem) {
  for (int row = 0; row < kEnds; ++row) {
    if (!piece.free[row / kJointOrder]) continue;
    for (int column = 0; column < kEnds; ++column) {
      if (!piece.free[column / kJointOrder]) {
        add_linear(piece, row, column, problem);
      } else if (column <= row) {
        problem.hessian[unknown_of(piece, row)][row - column] +=
            piece.cost * kSnapForm[row][column] * (piece.factor[row] * piece.factor[column]);
      }
    }
  }
}

bool touches(const double* weights, int end) {
  for (int k = end * kJointOrder; k < (end + 1) * kJointOrder; ++k) {
    if (weights[k] < 0.0 || weights[k] > 0.0) return true;
  }
  return false;
}

/// What derivative j of an end counts for in the weighted sum of its four control points.
double end_weight(const double* weights, int end, int j) {
  double sum = 0.0;
  for (int k = j; k < kJointOrder; ++k) {
    sum += weights[end == 0 ? k : kDegree - k] * kFirstEnd[k][j];
  }
  return end == 1 && (j % 2) == 1 ? -sum : sum;
}

/// Appends the point multiplier * sum_k weights[k] c[k]; not where it is constant.
void add_point(const Piece& piece, const double* weights, double multiplier, const PointOrigin& origin,
               ProgrammeScale& scale, QpProblem& problem) {
  QpPoint point{};
  for (int end = 0; end < 2; ++end) {
    if (!touches(weights, end)) continue;
    for (int j = 0; j < kJointOrder; ++j) {
      const int e = end * kJointOrder + j;
      const double weight = multiplier * end_weight(weights, end, j);
      if (piece.free[end]) {
        if (point.terms == 0) point.first = static_cast<std::int16_t>(unknown_of(piece, e));
        point.coefficient[point.terms] = weight * piece.factor[e];
        ++point.terms;
      } else {
        point.offset = point.offset + weight * piece.fixed[e];
      }
    }
  }
  if (point.terms == 0) return;
  problem.points[problem.point_count] = point;
  scale.origin[problem.point_count] = origin;
  ++problem.point_count;
}

void add_group(int point_begin, int plane_begin, int plane_end, QpProblem& problem) {
  if (point_begin == problem.point_count) return;
  problem.groups[problem.group_count] = QpGroup{point_begin, problem.point_count, plane_begin, plane_end};
  ++problem.group_count;
}

/// The planes of polyhedra [0, count), relative to the centre, one polyhedron after the other.
void add_polyhedron(const Polyhedron& polyhedron, const Vec3& center, QpProblem& problem) {
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    problem.planes[problem.plane_count] = Halfspace{plane.normal, plane.offset - dot(plane.normal, center)};
    ++problem.plane_count;
  }
}

PointOrigin origin_of(int segment, int order, int row) {
  return {static_cast<std::int16_t>(segment), static_cast<std::int8_t>(order), static_cast<std::int8_t>(row)};
}

void add_corridor(const Chain& chain, const Corridor& corridor, ProgrammeScale& scale, QpProblem& problem) {
  int plane_begin = 0;
  for (int i = 0; i < chain.count; ++i) {
    if (i == 0 || chain.polyhedron[i] != chain.polyhedron[i - 1]) {
      plane_begin = problem.plane_count;
      add_polyhedron(corridor.polyhedra[chain.polyhedron[i]], chain.center, problem);
    }
    const Piece piece = piece_of(chain, scale, i);
    const int point_begin = problem.point_count;
    for (int k = 0; k < kControlPoints; ++k) {
      double weights[kControlPoints] = {};
      weights[k] = 1.0;
      add_point(piece, weights, 1.0, origin_of(i, 0, k), scale, problem);
    }
    add_group(point_begin, plane_begin, problem.plane_count, problem);
  }
}

/// One kind of limit for every segment. The first row of a segment is the last one of the segment before.
void add_limit_rows(const Chain& chain, ProgrammeScale& scale, const LimitPlanes& limit, int order,
                    QpProblem& problem) {
  const OrderRows rows = rows_of(order);
  const int plane_begin = problem.plane_count;
  scale.unit[order] = limit.unit;
  for (int p = 0; p < limit.count; ++p) problem.planes[problem.plane_count + p] = limit.planes[p];
  problem.plane_count += limit.count;
  for (int i = 0; i < chain.count; ++i) {
    const Piece piece = piece_of(chain, scale, i);
    const double multiplier = 1.0 / (power_of(chain.duration[i], order) * limit.unit);
    const int point_begin = problem.point_count;
    for (int r = i == 0 ? 0 : 1; r < rows.count; ++r) {
      add_point(piece, rows.weights[r], multiplier, origin_of(i, order, r), scale, problem);
    }
    add_group(point_begin, plane_begin, problem.plane_count, problem);
  }
}

/// The horizontal direction in which a limit is kept without loss: that of a boundary state, which is given.
Vec3 kept_direction(const Chain& chain, int order) {
  return horizontal_length(chain.start.d[order]) > 0.0 ? chain.start.d[order] : chain.goal.d[order];
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

/// The state of interior joint `joint` (0 .. count - 2) that x stands for, local frame, seconds.
JointState read_joint(const Chain& chain, const ProgrammeScale& scale, const QpSolution& solution, int joint) {
  JointState state{};
  double power = 1.0;
  for (int k = 0; k < kJointOrder; ++k) {
    for (int a = 0; a < kQpAxes; ++a) {
      axis(state.d[k], a) = scale.joint[joint][k] * solution.x[a][kJointOrder * joint + k] / power;
    }
    power *= scale.tau;
  }
  state.d[0] = state.d[0] + chain.center;
  return state;
}

}  // namespace

void assemble(const Chain& chain, const Corridor& corridor, const MotionLimits& limits, QpProblem& problem,
              ProgrammeScale& scale) noexcept {
  clear(kJointOrder * (chain.count - 1), problem);
  scale.tau = mean_duration(chain);
  scale.unit[0] = 1.0;
  scale.snap_per_cost = 2.0 / (kCostScale * seventh_power(scale.tau));
  scale_joints(chain, scale);
  for (int i = 0; i < chain.count; ++i) add_cost(piece_of(chain, scale, i), problem);
  add_corridor(chain, corridor, scale, problem);
  const LimitPlanes velocity = limit_planes(limits.velocity, kept_direction(chain, 1));
  const LimitPlanes acceleration = limit_planes(limits.acceleration, kept_direction(chain, 2));
  add_limit_rows(chain, scale, velocity, 1, problem);
  add_limit_rows(chain, scale, acceleration, 2, problem);
  if (!limits_anything(limits.jerk)) return;
  add_limit_rows(chain, scale, limit_planes(limits.jerk, kept_direction(chain, 3), kJerkMargin), 3, problem);
}

void read_points(const Chain& chain, const ProgrammeScale& scale, const QpSolution& solution,
                 Vec3 (*points)[kControlPoints]) noexcept {
  JointState first = chain.start;
  for (int i = 0; i < chain.count; ++i) {
    const JointState second = i + 1 < chain.count ? read_joint(chain, scale, solution, i) : chain.goal;
    control_points(first, second, chain.duration[i], points[i]);
    first = second;
  }
}

}  // namespace tern
