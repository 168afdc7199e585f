// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Instructions of the solver's operations, from the current sizes (see Work). Measured on aarch64 and x86-64, and
// rounded up.
#ifndef TERN_QP_EFFORT_HPP
#define TERN_QP_EFFORT_HPP

#include <cstdint>

#include "base/work.hpp"
#include "qp/solver.hpp"

namespace tern::qp {

/// A turn of a loop over the unknowns: a substitution with the band of the Hessian's factor.
constexpr std::uint32_t kUnknownEffort = 70;
/// An active row: its violation, or its part of A'y.
constexpr std::uint32_t kRowEffort = 150;
/// A batch that a scan skips, a batch that it prices, and a plane of the priced batch's group.
constexpr std::uint32_t kSkipEffort = 16;
constexpr std::uint32_t kBatchEffort = 900;
constexpr std::uint32_t kPlaneEffort = 55;
/// A point that is priced alone, and a plane of its group.
constexpr std::uint32_t kPointEffort = 450;
constexpr std::uint32_t kPointPlaneEffort = 20;
/// A unit of work, besides the operations below.
constexpr std::uint32_t kIterationEffort = 400;

/// A pass over the basis: a projection on it, or a combination of its columns.
inline std::uint32_t basis_effort(const QpSolver& solver) {
  return 200 + effort_of(2, solver.active_count * solver.stride);
}

/// A substitution with the triangle of the active rows.
inline std::uint32_t triangle_effort(const QpSolver& solver) {
  return 100 + effort_of(1, solver.active_count * (solver.active_count + 10));
}

/// Rotations that take out row j of the active ones.
inline std::uint32_t rotation_effort(const QpSolver& solver, int j) {
  const int later = solver.active_count - 1 - j;
  return 200 + effort_of(5, later * solver.stride) + effort_of(5, later * solver.active_count);
}

inline std::uint32_t unknowns_effort(const QpSolver& solver) {
  return effort_of(kUnknownEffort, solver.unknowns);
}

/// The residuals of an answer.
inline std::uint32_t measure_effort(const QpSolver& solver) {
  return 500 + 4 * unknowns_effort(solver) + effort_of(2 * kRowEffort, solver.active_count + 1);
}

/// The beginning of a solve.
inline std::uint32_t begin_effort(const QpProblem& problem) {
  return 1000 + effort_of(4 * kUnknownEffort, problem.unknowns) + effort_of(8, problem.point_count) +
         effort_of(40, problem.plane_count) + effort_of(120, problem.group_count);
}

}  // namespace tern::qp

#endif
