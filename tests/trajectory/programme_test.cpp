// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/programme.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "curve/bezier.hpp"
#include "support/box_corridor.hpp"
#include "support/chain.hpp"
#include "tern/trajectory.hpp"
#include "trajectory/hodograph_points.hpp"
#include "trajectory/turning.hpp"
#include "trajectory/turning_rows.hpp"

namespace {

using namespace tern;

/// A programme over a random chain with a random solution of it: any x stands for a trajectory.
struct Case {
  Corridor corridor;
  Limits limits;
  Chain chain;
  ProgrammeScale scale;
  QpProblem problem;
  QpSolution solution;
  Vec3 points[kMaxSegments][kControlPoints];

  explicit Case(tern_test::Random& random, int polyhedra = 4) {
    corridor = tern_test::random_corridor(random, polyhedra, 4.0, 0.2);
    limits = tern_test::random_limits(random);
    const State start{corridor.polyhedra[0].from, {0.3, -0.2, 0.1}, {0.2, 0.1, -0.3}};
    const State goal{corridor.polyhedra[polyhedra - 1].to, {0.1, 0.2, 0.0}, {0.0, -0.1, 0.2}};
    tern_test::make_chain(corridor, start, goal, limits, chain);
    for (int i = 0; i < chain.count; ++i) chain.duration[i] *= random.real(0.5, 2.0);
    assemble(chain, corridor, limits, nullptr, problem, scale);
    draw(random);
  }
  void draw(tern_test::Random& random) {
    for (int a = 0; a < 3; ++a) {
      for (int i = 0; i < problem.unknowns; ++i) solution.x[a][i] = random.real(-1.0, 1.0);
    }
    read_points(chain, scale, solution, points);
  }
  double objective() const {
    double sum = 0.0;
    for (int a = 0; a < 3; ++a) {
      for (int i = 0; i < problem.unknowns; ++i) {
        sum += problem.linear[a][i] * solution.x[a][i] + 0.5 * problem.hessian[i][0] * std::pow(solution.x[a][i], 2);
        for (int d = 1; d <= kQpBand && d <= i; ++d) {
          sum += problem.hessian[i][d] * solution.x[a][i] * solution.x[a][i - d];
        }
      }
    }
    return sum;
  }
  Trajectory trajectory() const {
    Trajectory result{};
    result.count = chain.count;
    for (int i = 0; i < chain.count; ++i) {
      result.segments[i].duration = chain.duration[i];
      for (int k = 0; k < kControlPoints; ++k) result.segments[i].points[k] = points[i][k];
    }
    return result;
  }
  Vec3 point(int index) const {
    const QpPoint& p = problem.points[index];
    double value[3] = {p.offset.x, p.offset.y, p.offset.z};
    for (int a = 0; a < 3; ++a) {
      for (int t = 0; t < p.terms; ++t) value[a] += p.coefficient[t] * solution.x[a][p.first + t];
    }
    return {value[0], value[1], value[2]};
  }
};

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(SnapForm, MatchesQuadrature) {
  tern_test::Random random(1);
  double end[8];
  for (double& value : end) value = random.real(-1.0, 1.0);
  JointState states[2]{};
  for (int k = 0; k < 4; ++k) {
    states[0].d[k].x = end[k];
    states[1].d[k].x = end[4 + k];
  }
  Segment segment{};
  segment.duration = 1.0;
  control_points(states[0], states[1], 1.0, segment.points);
  Curve snap = curve_of(segment);
  for (int k = 0; k < 4; ++k) snap = hodograph(snap, 1.0);
  double quadrature = 0.0;
  for (int i = 0; i < 20000; ++i) quadrature += std::pow(value(snap, (i + 0.5) / 20000).x, 2) / 20000;
  double form = 0.0;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) form += kSnapForm[i][j] * end[i] * end[j];
  }
  EXPECT_NEAR(form, quadrature, 1e-6 * quadrature);
}

TEST(ControlPoints, CarryTheEndsDerivatives) {
  const JointState first{{{1, 2, 3}, {0.5, -1, 2}, {3, 1, -2}, {0.1, 4, -3}}};
  const JointState second{{{-1, 0, 2}, {1, 1, -2}, {0.3, -1, 2}, {1.1, -4, 3}}};
  Trajectory trajectory{};
  trajectory.count = 1;
  trajectory.segments[0].duration = 1.7;
  control_points(first, second, 1.7, trajectory.segments[0].points);
  const Sample start = evaluate(trajectory, 0.0);
  expect_near(start.position, first.d[0], 0.0);
  expect_near(start.velocity, first.d[1], 1e-13);
  expect_near(start.acceleration, first.d[2], 1e-12);
  expect_near(start.jerk, first.d[3], 1e-11);
  const Sample end = evaluate(trajectory, std::nextafter(1.7, 0.0));
  expect_near(end.velocity, second.d[1], 1e-11);
  expect_near(end.acceleration, second.d[2], 1e-11);
  expect_near(end.jerk, second.d[3], 1e-11);
}

TEST(Programme, DiagonalIsOne) {
  tern_test::Random random(2);
  const auto c = std::make_unique<Case>(random);
  for (int i = 0; i < c->problem.unknowns; ++i) EXPECT_NEAR(c->problem.hessian[i][0], 1.0, 1e-14);
}

TEST(Programme, ObjectiveIsTheSnapCostButForAConstantAndAScale) {
  tern_test::Random random(3);
  for (int n = 0; n < tern_test::scaled(20); ++n) {
    const auto c = std::make_unique<Case>(random);
    const double tau = std::pow(c->scale.tau, 7);
    const double constant = c->objective() - 0.5e-5 * tau * snap_cost(c->trajectory());
    const double size = std::fabs(c->objective()) + 1.0;
    for (int i = 0; i < 5; ++i) {
      c->draw(random);
      EXPECT_NEAR(c->objective() - 0.5e-5 * tau * snap_cost(c->trajectory()), constant, 1e-8 * size);
    }
  }
}

TEST(Programme, JointsAreSharedToJerk) {
  tern_test::Random random(4);
  const auto c = std::make_unique<Case>(random);
  const Trajectory trajectory = c->trajectory();
  for (int i = 0; i + 1 < trajectory.count; ++i) {
    EXPECT_EQ(trajectory.segments[i].points[kDegree].x, trajectory.segments[i + 1].points[0].x);
    Curve before = curve_of(trajectory.segments[i]);
    Curve after = curve_of(trajectory.segments[i + 1]);
    for (int k = 0; k < 4; ++k) {
      const double largest = std::sqrt(dot(after.c[0], after.c[0]));
      expect_near(before.c[before.degree], after.c[0], 1e-9 * (1.0 + largest));
      before = hodograph(before, trajectory.segments[i].duration);
      after = hodograph(after, trajectory.segments[i + 1].duration);
    }
  }
}

TEST(Programme, PointsAreTheControlPointsAndTheHodographsHalves) {
  tern_test::Random random(5);
  const auto c = std::make_unique<Case>(random);
  const Trajectory trajectory = c->trajectory();
  const Vec3& center = c->chain.center;
  int index = 0;
  for (int i = 0; i < c->chain.count; ++i) {
    for (int k = i == 0 ? 4 : 0; k < (i + 1 == c->chain.count ? 4 : 8); ++k) {
      const Vec3 p = c->point(index++);
      expect_near({p.x + center.x, p.y + center.y, p.z + center.z}, trajectory.segments[i].points[k], 1e-10);
    }
  }
  // The first row of velocity that has unknowns: of the first half's hodograph, the fourth control point.
  const double unit = std::fmin(std::fmin(c->limits.v_max.x, c->limits.v_max.y), c->limits.v_max.z);
  Curve half = hodograph(curve_of(trajectory.segments[0]), trajectory.segments[0].duration);
  split(half);
  EXPECT_NEAR(c->point(index).x * unit, half.c[3].x, 1e-10);
}

TEST(Programme, WarmRowsKeepTheirMeaningAcrossDurations) {
  tern_test::Random random(6);
  const auto c = std::make_unique<Case>(random);
  const auto other = std::make_unique<QpProblem>();
  const auto scale = std::make_unique<ProgrammeScale>();
  for (int i = 0; i < c->chain.count; ++i) c->chain.duration[i] *= random.real(0.5, 2.0);
  assemble(c->chain, c->corridor, c->limits, nullptr, *other, *scale);
  ASSERT_EQ(other->point_count, c->problem.point_count);
  ASSERT_EQ(other->plane_count, c->problem.plane_count);
  for (int i = 0; i < other->point_count; ++i) {
    EXPECT_EQ(other->points[i].first, c->problem.points[i].first);
    EXPECT_EQ(scale->origin[i].segment, c->scale.origin[i].segment);
    EXPECT_EQ(scale->origin[i].order, c->scale.origin[i].order);
    EXPECT_EQ(scale->origin[i].index, c->scale.origin[i].index);
  }
  for (int i = 0; i < other->plane_count; ++i) EXPECT_EQ(other->planes[i].normal.x, c->problem.planes[i].normal.x);
}

/// A segment without unknowns has no points. Here it is the first one, which ends at rest at a via, and then the only
/// one of a chain.
TEST(Programme, RowsOfBodyRatesAreThoseOfTheirInstants) {
  tern_test::Random random(8);
  const auto c = std::make_unique<Case>(random);
  Chain& chain = c->chain;
  ASSERT_GE(chain.count, 4);
  Limits limits = c->limits;
  limits.rate_max = 3.0;
  const auto turning = std::make_unique<Turning>();
  first_turning(chain, limits, *turning);
  chain.via_joint_count = 1;
  chain.via_joints[0] = {};
  chain.via_joints[0].segment = 1;
  chain.via_joints[0].stop = true;
  chain.via_joints[0].position = c->corridor.polyhedra[0].to;
  assemble(chain, c->corridor, limits, turning.get(), c->problem, c->scale);
  std::array<int, kMaxSegments> rows{};
  for (int g = 0; g < c->problem.group_count; ++g) {
    const QpGroup& group = c->problem.groups[g];
    ASSERT_LT(group.point_begin, group.point_end);
    ASSERT_LE(group.point_end, c->problem.point_count);
    const int row = group.plane_begin - c->scale.turning;
    if (row < 0 || row >= kQpTurningPlanes * kJerkPoints * chain.count) continue;
    const int order = row % kQpTurningPlanes == 0 ? 2 : 3;
    ++rows[static_cast<std::size_t>(row / kQpTurningPlanes / kJerkPoints)];
    for (int k = group.point_begin; k < group.point_end; ++k) {
      const PointOrigin& origin = c->scale.origin[k];
      EXPECT_EQ(origin.order, order);
      EXPECT_EQ(origin.segment, row / kQpTurningPlanes / kJerkPoints);
      const int instant = order == 3 ? origin.index : nearest_jerk_point(origin.index);
      EXPECT_EQ(instant, row / kQpTurningPlanes % kJerkPoints);
    }
  }
  EXPECT_EQ(rows[0], 0);
  EXPECT_EQ(rows[2], 2 * kJerkPoints - 1);
  chain.count = 1;
  chain.via_joint_count = 0;
  assemble(chain, c->corridor, limits, turning.get(), c->problem, c->scale);
  EXPECT_EQ(c->problem.group_count, 0);
}

TEST(HodographPoints, BoundTheWholeCurve) {
  tern_test::Random random(7);
  constexpr Bounds unit{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, 0.0};
  for (int n = 0; n < tern_test::scaled(200); ++n) {
    Segment segment{};
    segment.duration = 1.0;
    for (Vec3& point : segment.points) point.x = random.real(-1.0, 1.0);
    double velocity = 0.0;
    for (const auto& row : kHodographPoints.velocity) {
      double sum = 0.0;
      for (int k = 0; k < kControlPoints; ++k) sum += row[k] * segment.points[k].x;
      velocity = std::fmax(velocity, std::fabs(sum));
    }
    EXPECT_GE(velocity, peak_bound(hodograph(curve_of(segment), 1.0), unit, 0.0, 1e-9) * (1.0 - 1e-8));
  }
}

}  // namespace
