// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TARGET_TABLE_HPP
#define TERN_BENCH_TARGET_TABLE_HPP

#include <string>
#include <vector>

#include "target/measure.hpp"

namespace tern_target {

/// The heading of the columns that table_of() fills.
std::string table_heading();

/// One scenario's rows in nanoseconds and cycles, "-" for what was not to be had.
std::string table_of(const CaseFigures& figures);

/// The file that bench/results/<board>/stages.csv is: the notes as comments, then a row a map and stage in
/// microseconds; cycles, where counted, in further columns.
std::string csv_of(const std::vector<CaseFigures>& cases, const std::vector<std::string>& notes);

}  // namespace tern_target

#endif
