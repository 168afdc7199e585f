// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TIMING_MAP_ROWS_HPP
#define TERN_BENCH_TIMING_MAP_ROWS_HPP

namespace tern_timing {

/// Prints what the jobs of rolling maps count: a row for each window and job. False if a map refuses something.
bool print_map_rows();

}  // namespace tern_timing

#endif
