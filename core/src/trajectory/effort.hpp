// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Instructions of the trajectory stage's units besides those of the solver (see Work). Measured on aarch64 and x86-64,
// and rounded up.
#ifndef TERN_TRAJECTORY_EFFORT_HPP
#define TERN_TRAJECTORY_EFFORT_HPP

#include <cstdint>

#include "base/work.hpp"
#include "qp/qp.hpp"
#include "times/chain.hpp"

namespace tern {

/// A duration tried for a segment at an end.
constexpr std::uint32_t kEndEffort = 6000;
/// The assembly of a programme, and the snap of the chain with all unknowns zero.
inline std::uint32_t assembly_effort(const Chain& chain, const QpProblem& problem) {
  return 2000 + effort_of(5000, chain.count) + effort_of(170, problem.point_count) + effort_of(25, problem.plane_count);
}

/// A judgement, whatever it decides.
constexpr std::uint32_t kJudgementEffort = 3000;

/// Reading the points of a solution, and checking them against polyhedra and limits.
inline std::uint32_t points_effort(const Chain& chain) {
  return effort_of(6000, chain.count);
}

/// Computing the prices of the durations.
inline std::uint32_t prices_effort(const Chain& chain, const QpSolution& solution) {
  return effort_of(3000, chain.count) + effort_of(400, solution.active_count);
}

/// Stop-and-go along `polyhedra` polyhedra. At ends in motion, brakings are tried.
inline std::uint32_t rest_effort(int polyhedra, bool at_rest) {
  return effort_of(600, polyhedra) + (at_rest ? 0 : 150000);
}

}  // namespace tern

#endif
