// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_CORRIDOR_REPORT_HPP
#define TERN_BENCH_CORRIDOR_REPORT_HPP

#include <string>

#include "measure.hpp"

namespace tern_bench {

/// The columns of one family, for a terminal and as CSV.
std::string table_header();
std::string table_row(const std::string& family, const Samples& samples);
std::string csv_header();
std::string csv_row(const std::string& family, const Samples& samples);

/// What the local box saves over all families' segments, in the mean. The paper looks at every obstacle without it.
std::string savings(const Samples& all);

/// Adds what `savings` needs of `more`.
void append_voxels(Samples& all, const Samples& more);

}  // namespace tern_bench

#endif
