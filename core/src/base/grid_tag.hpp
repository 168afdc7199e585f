// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BASE_GRID_TAG_HPP
#define TERN_BASE_GRID_TAG_HPP

#include <cstdint>

namespace tern {

/// A tern_grid's first word once a grid was bound there; the grid follows it.
constexpr std::uint64_t kGridTag = 0x7465726E2D677269u;
/// A tern_map's first word once a map was bound there; the map follows it.
constexpr std::uint64_t kMapTag = 0x7465726E2D6D6170u;

}  // namespace tern

#endif
