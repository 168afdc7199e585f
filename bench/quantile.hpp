// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_QUANTILE_HPP
#define TERN_BENCH_QUANTILE_HPP

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tern_bench {

/// The value that a part `q` of [0, 1] of the values does not exceed, to the nearest rank, one of them; 0 for no
/// values.
inline double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

}  // namespace tern_bench

#endif
