// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rows of tools/bench scale that are no plans. They print themselves, and go to the CSV.
#ifndef TERN_BENCH_SCALE_ROWS_HPP
#define TERN_BENCH_SCALE_ROWS_HPP

#include <iosfwd>

namespace tern_bench {

void over_cities(std::ofstream& csv);
void over_vehicles(std::ofstream& csv);

}  // namespace tern_bench

#endif
