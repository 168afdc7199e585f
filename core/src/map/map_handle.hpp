// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map behind a handle of the C interface.
#ifndef TERN_MAP_MAP_HANDLE_HPP
#define TERN_MAP_MAP_HANDLE_HPP

#include <cstdint>
#include <new>

#include "tern/tern_map.h"

namespace tern {

/// A tern_map's first word once a map was bound there; the map follows it.
constexpr std::uint64_t kMapTag = 0x7465726E2D6D6170u;

/// The map, or an unbound one if there is none. The memory may be uninitialised. A volatile read gives the word one
/// definite value.
inline RollingMap object(const tern_map* map) {
  if (map == nullptr || *static_cast<const volatile std::uint64_t*>(map->opaque) != kMapTag) return RollingMap{};
  return *std::launder(reinterpret_cast<const RollingMap*>(map->opaque + 1));
}

}  // namespace tern

#endif
