// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_SEARCH_REPORT_HPP
#define TERN_BENCH_SEARCH_REPORT_HPP

#include <string>

#include "search/contest.hpp"

namespace tern_bench {

/// The columns of one outcome: for a terminal, and as CSV. Times in microseconds, totals in milliseconds.
std::string table_header();
std::string table_row(const Outcome& outcome);
std::string csv_header();
std::string csv_row(const Outcome& outcome);

}  // namespace tern_bench

#endif
