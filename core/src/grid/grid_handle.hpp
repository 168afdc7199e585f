// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The grid behind a handle of the C interface.
#ifndef TERN_GRID_GRID_HANDLE_HPP
#define TERN_GRID_GRID_HANDLE_HPP

#include <cstdint>
#include <new>

#include "tern/tern.h"

namespace tern {

/// A tern_grid's first word once a grid was bound there; the grid follows it.
constexpr std::uint64_t kGridTag = 0x7465726E2D677269u;

/// Stands in for a grid that was never bound.
constexpr Grid kNoGrid{};

/// True if there is a grid. The memory may be uninitialised. A volatile read gives the word one definite value.
inline bool holds_grid(const tern_grid* grid) {
  return *static_cast<const volatile std::uint64_t*>(grid->opaque) == kGridTag;
}
/// The grid behind the handle; null if there is none.
inline Grid* object(tern_grid* grid) {
  if (grid == nullptr || !holds_grid(grid)) return nullptr;
  return std::launder(reinterpret_cast<Grid*>(grid->opaque + 1));
}
inline const Grid& object(const tern_grid* grid) {
  return holds_grid(grid) ? *std::launder(reinterpret_cast<const Grid*>(grid->opaque + 1)) : kNoGrid;
}

}  // namespace tern

#endif
