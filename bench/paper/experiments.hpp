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

}  // namespace tern_bench

#endif
