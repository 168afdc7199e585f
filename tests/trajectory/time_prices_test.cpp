// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The prices of time against differences of solved programmes.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "curve/bezier.hpp"
#include "qp/solver.hpp"
#include "support/box_corridor.hpp"
#include "support/chain.hpp"
#include "trajectory/programme.hpp"

namespace {

using namespace tern;

class TimePrices : public testing::Test {
 protected:
  struct Memory {
    Chain chain;
    Corridor corridor;
    QpProblem problem;
    QpSolution solution;
    QpSolver solver;
    ProgrammeScale scale;
    Vec3 points[kMaxSegments][kControlPoints];
  };

  /// The least snap at the chain's durations; negative where there is none.
  double solve() {
    Memory& m = *memory_;
    assemble(m.chain, m.corridor, limits_, nullptr, m.problem, m.scale);
    qp_begin(m.solver, m.problem, nullptr, 0);
    Work work{0xFFFFFFFFu};
    if (qp_advance(m.solver, m.problem, work, m.solution) != Status::kOk) return -1.0;
    read_points(m.chain, m.scale, m.solution, m.points);
    double snap = 0.0;
    for (int i = 0; i < m.chain.count; ++i) {
      Segment segment{};
      segment.duration = m.chain.duration[i];
      for (int k = 0; k < kControlPoints; ++k) segment.points[k] = m.points[i][k];
      const Curve curve = snap_of(segment);
      snap += integral_of_product(curve, curve, segment.duration);
    }
    return snap;
  }

  /// -T dJ/dT by central differences over two solves.
  double difference(int i) {
    constexpr double kStep = 1e-4;
    double& duration = memory_->chain.duration[i];
    const double middle = duration;
    duration = middle * (1.0 + kStep);
    const double longer = solve();
    duration = middle * (1.0 - kStep);
    const double shorter = solve();
    duration = middle;
    return (shorter - longer) / (2.0 * kStep);
  }

  std::unique_ptr<Memory> memory_ = std::make_unique<Memory>();
  Limits limits_{};
  int total_ = 0;
};

TEST_F(TimePrices, AreTheDerivativeOfTheLeastSnap) {
  tern_test::Random random(1);
  int compared = 0;
  int with_limits = 0;
  const int cases = tern_test::scaled(150);
  for (int n = 0; n < cases; ++n) {
    Memory& m = *memory_;
    m.corridor = tern_test::random_corridor(random, random.integer(2, 4), 8.0, 2.0);
    limits_ = random.chance(0.5) ? tern_test::random_limits(random) : tern_test::random_uneven_limits(random);
    State start{};
    State goal{};
    start.position = m.corridor.polyhedra[0].from;
    goal.position = m.corridor.polyhedra[m.corridor.count - 1].to;
    tern_test::make_chain(m.corridor, start, goal, limits_, m.chain);
    for (int i = 0; i < m.chain.count; ++i) m.chain.duration[i] *= random.real(0.6, 1.0);
    const double snap = solve();
    if (snap < 0.0) continue;
    double prices[kMaxSegments];
    time_prices(m.chain, m.problem, m.solution, m.scale, m.points, prices);
    for (int r = 0; r < m.solution.active_count; ++r) {
      with_limits += m.scale.origin[m.solution.active[r].point].order > 0 ? 1 : 0;
    }
    for (int i = 0; i < m.chain.count; ++i) {
      // A working set that changes within the step bends the difference: most cases must agree, not each.
      compared += std::fabs(prices[i] - difference(i)) <= 1e-2 * (std::fabs(prices[i]) + 0.1 * snap) ? 1 : 0;
      ++total_;
    }
  }
  EXPECT_GE(compared, total_ * 97 / 100) << total_;
  EXPECT_GT(with_limits, cases / 2);
  EXPECT_GT(total_, cases * 2);
}

}  // namespace
