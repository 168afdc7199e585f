// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A quadratic programme with the unknowns and more rows than the largest trajectory has, so made that rows enter and
// leave for longer than they may.
#include <cstddef>

#include "base/math.hpp"
#include "caps/cap.hpp"
#include "qp/solver.hpp"
#include "support/random.hpp"

namespace tern_caps {
namespace {

using tern_test::Random;

/// Only the first unknowns are constrained, so many that their rows, as far as they are independent, fit the working
/// set; the factors reach over all.
constexpr int kConstrained = tern::kMaxActive / tern::kQpAxes - 2;
constexpr int kStride = 2;
constexpr int kGroups = (kConstrained - tern::kQpPointTerms) / kStride + 1;
constexpr int kPoints = 30;
/// How far beyond the rows the minimum without them lies: the further, the more rows come and go.
constexpr double kPull = 1000.0;
constexpr double kCoupling = 0.9;

constexpr std::size_t kSolverOffset = std::size_t{4} << 20;
constexpr std::size_t kSolutionOffset = std::size_t{16} << 20;

void fill_cost(Random& random, tern::QpProblem& problem) {
  problem.unknowns = tern::kQpMaxUnknowns - 2;
  for (int i = 0; i < problem.unknowns; ++i) {
    problem.hessian[i][0] = 1.0;
    for (int d = 1; d <= tern::kQpBand; ++d) {
      problem.hessian[i][d] = d <= i ? kCoupling * random.real(-1.0, 1.0) / tern::kQpBand : 0.0;
    }
    for (auto& axis : problem.linear) axis[i] = kPull * random.real(-1.0, 1.0);
  }
}

void add_point(Random& random, int first, tern::QpProblem& problem) {
  tern::QpPoint& point = problem.points[problem.point_count++];
  point.offset = {0.0, 0.0, 0.0};
  point.first = static_cast<std::int16_t>(first);
  point.terms = tern::kQpPointTerms;
  for (double& coefficient : point.coefficient) coefficient = random.real(-1.0, 1.0);
}

/// A plane at distance 1 from the origin, anyhow turned: their polyhedron is nearly a ball.
void add_plane(Random& random, tern::QpProblem& problem) {
  tern::Vec3 normal;
  double squared;
  do {
    normal = {random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    squared = tern::dot(normal, normal);
  } while (squared > 1.0 || squared < 0.01);
  problem.planes[problem.plane_count++] = {(1.0 / tern::square_root(squared)) * normal, 1.0};
}

void fill_rows(Random& random, tern::QpProblem& problem) {
  problem.point_count = problem.plane_count = problem.group_count = 0;
  for (int g = 0; g < kGroups; ++g) {
    tern::QpGroup& group = problem.groups[problem.group_count++];
    group.point_begin = problem.point_count;
    group.plane_begin = problem.plane_count;
    for (int k = 0; k < kPoints; ++k) add_point(random, g * kStride, problem);
    for (int p = 0; p < tern::kMaxPlanes; ++p) add_plane(random, problem);
    group.point_end = problem.point_count;
    group.plane_end = problem.plane_count;
  }
}

/// Rows at random, as many as a warm start may name: each is put in, and most are taken out again.
void begin(Random& random, const tern::QpProblem& problem, tern::QpSolver& solver) {
  static tern::QpConstraint warm[tern::kMaxActive];
  for (tern::QpConstraint& row : warm) {
    const tern::QpGroup& group = problem.groups[random.integer(0, kGroups - 1)];
    row.point = random.integer(group.point_begin, group.point_end - 1);
    row.plane = random.integer(group.plane_begin, group.plane_end - 1);
  }
  tern::qp_begin(solver, problem, warm, tern::kMaxActive);
}

}  // namespace

void programme_caps() {
  constexpr int kSlice = 100;
  auto& problem = state_at<tern::QpProblem>(0);
  auto& solver = state_at<tern::QpSolver>(kSolverOffset);
  auto& solution = state_at<tern::QpSolution>(kSolutionOffset);
  Random random(1);
  fill_cost(random, problem);
  fill_rows(random, problem);
  std::uint64_t instructions = count([&] { begin(random, problem, solver); });
  tern::Status status = tern::Status::kRunning;
  tern::Work work{kUnlimited};
  while (status == tern::Status::kRunning) {
    instructions += count([&] { status = tern::qp_advance(solver, problem, work, solution, kSlice); });
  }
  const auto iterations = static_cast<std::uint64_t>(solution.iterations);
  report({"qp_iterations", "trajectory", instructions, status == tern::Status::kIterationLimit ? iterations : 0,
          tern::kMaxQpIterations, units_of(work), tern::kMaxQpSolves});
}

}  // namespace tern_caps
