// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TRACKER_MATCHING_HPP
#define TERN_TRACKER_MATCHING_HPP

#include <cstddef>
#include <vector>

namespace tern_tracker {

/// One possible pair of a row and a column, and what it gains, > 0.
struct Pair {
  std::size_t row, column;
  double gain;
};

constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);

/// The column of each row, or kNoColumn, so that no column is taken twice and the sum of gains is largest.
std::vector<std::size_t> best_matching(std::size_t rows, std::size_t columns, const std::vector<Pair>& pairs);

}  // namespace tern_tracker

#endif
