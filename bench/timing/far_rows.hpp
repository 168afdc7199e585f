// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TIMING_FAR_ROWS_HPP
#define TERN_BENCH_TIMING_FAR_ROWS_HPP

#include "tern/workspace.hpp"

namespace tern_timing {

/// Prints what a far way through a city counts. False if it finds none.
bool print_far_rows(tern::Workspace& workspace);

}  // namespace tern_timing

#endif
