// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The experiments of the paper's Section 4, one function each. Each writes its tables and pictures into the run's
// folder.
#ifndef TERN_BENCH_PAPER_EXPERIMENTS_HPP
#define TERN_BENCH_PAPER_EXPERIMENTS_HPP

#include "paper/run.hpp"

namespace tern_bench {

/// Table 4, Figures 9 to 14: front ends on the six maps. front_end.csv, map<n>_paths.svg.
void front_end_experiment(const Run& run);
/// Table 5: front ends on random maps. monte_carlo.csv, monte_carlo.svg.
void monte_carlo_experiment(const Run& run);
/// Table 6, Figures 15 to 17, the limits of Section 4.5: corridors.csv, limits.csv, map<n>_corridor.svg.
void corridors_experiment(const Run& run);
/// Table 7, Figures 18 to 23: polynomials and Bezier curves. back_end.csv, map<n>_trajectories.svg.
void back_end_experiment(const Run& run);
/// Figure 8, and each plan against its limits. profiles.csv, trapezoid.svg, map<n>_profiles.svg.
void profiles_experiment(const Run& run);

/// Table 8, Figure 24: whole planners on random maps. planners.csv, planners.svg.
void planners_experiment(const Run& run);
/// What Sections 3.2.4 and 3.3 claim: waypoint bound, complexity of the shortcut, iterations of the ellipsoid.
/// theory.csv, shortcut.csv, ellipsoid.csv, theory.svg.
void theory_experiment(const Run& run);

}  // namespace tern_bench

#endif
