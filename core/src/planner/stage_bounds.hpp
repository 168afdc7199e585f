// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contract C2: how much a stage works at most, known before it runs. It follows from capacities, and from the size of
// the grid where a capacity would say far more.
#ifndef TERN_PLANNER_STAGE_BOUNDS_HPP
#define TERN_PLANNER_STAGE_BOUNDS_HPP

#include <cstdint>

#include "base/work.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"

namespace tern {

/// Of one run of a stage.
struct StageBound {
  std::uint64_t pieces;  ///< the most pieces of work
  Operations piece;      ///< the most operations of one of them

  /// Units of `runs` runs.
  std::uint64_t units(std::uint64_t runs) const noexcept {
    return runs * pieces * (static_cast<std::uint64_t>(piece) / kUnit + 1);
  }
};

StageBound stage_bound(Stage stage, const GridSpec& spec) noexcept;

}  // namespace tern

#endif
