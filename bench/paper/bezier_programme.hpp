// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_BEZIER_PROGRAMME_HPP
#define TERN_BENCH_BEZIER_PROGRAMME_HPP

#include <memory>
#include <vector>

#include "host/scenario.hpp"
#include "qp/solver.hpp"
#include "tern/corridor.hpp"
#include "tern/trajectory.hpp"
#include "trajectory/programme.hpp"

namespace tern_bench {

/// The paper's own optimisation (Section 3.4.3), once: one Bezier segment a polyhedron, given durations, minimum snap,
/// control points inside the corridor; no limits, no search for durations. Solved by Tern's quadratic programme.
class BezierProgramme {
 public:
  BezierProgramme();

  /// kOk with the trajectory in the world frame (`origin`: the grid's), from rest to rest between the scenario's ends.
  tern::Status solve(const tern::Corridor& corridor, const std::vector<double>& durations,
                     const tern_host::Scenario& scenario, const tern::Vec3& origin, tern::Trajectory& out);

 private:
  std::unique_ptr<tern::QpProblem> problem_;
  std::unique_ptr<tern::QpSolver> solver_;
  std::unique_ptr<tern::QpSolution> solution_;
};

}  // namespace tern_bench

#endif
