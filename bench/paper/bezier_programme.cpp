// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/bezier_programme.hpp"

#include "base/math.hpp"

namespace tern_bench {

BezierProgramme::BezierProgramme()
    : problem_(new tern::QpProblem), solver_(new tern::QpSolver), solution_(new tern::QpSolution) {}

tern::Status BezierProgramme::solve(const tern::Corridor& corridor, const std::vector<double>& durations,
                                    const tern_host::Scenario& scenario, const tern::Vec3& origin,
                                    tern::Trajectory& out) {
  using tern::operator-;
  using tern::operator+;
  using tern::operator*;
  const tern::Vec3 none{0.0, 0.0, 0.0};
  tern::Chain chain{};
  chain.count = corridor.count;
  chain.start = {{scenario.start.position - origin, none, none, none}};
  chain.goal = {{scenario.goal.position - origin, none, none, none}};
  chain.center = 0.5 * (chain.start.d[0] + chain.goal.d[0]);
  for (int i = 0; i < chain.count; ++i) {
    chain.polyhedron[i] = i;
    chain.duration[i] = durations[static_cast<std::size_t>(i)];
  }
  static thread_local tern::ProgrammeScale scale{};
  // Limits that no flight reaches: the corridor's rows alone can be active.
  constexpr double kFree = tern::kMaxLimit;
  const tern::Limits limits{{kFree, kFree, kFree}, {kFree, kFree, kFree}};
  tern::assemble(chain, corridor, limits, nullptr, *problem_, scale);
  tern::qp_begin(*solver_, *problem_, nullptr, 0);
  tern::Work work{0xFFFFFFFFu};
  const tern::Status status = tern::qp_advance(*solver_, *problem_, work, *solution_);
  if (status != tern::Status::kOk) return status;
  static thread_local tern::Vec3 points[tern::kMaxSegments][tern::kControlPoints];
  tern::read_points(chain, scale, *solution_, points);
  out.count = chain.count;
  out.origin = origin;
  for (int i = 0; i < chain.count; ++i) {
    out.segments[i].duration = chain.duration[i];
    out.segments[i].polyhedron = i;
    for (int k = 0; k < tern::kControlPoints; ++k) out.segments[i].points[k] = points[i][k];
  }
  return status;
}

}  // namespace tern_bench
