// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_WORKSPACE_HPP
#define TERN_WORKSPACE_HPP

#include <cstddef>

#include "tern/config.hpp"

namespace tern {

/// Alignment of the planner's memory; a block that is not aligned is served from its first aligned byte.
constexpr std::size_t kWorkspaceAlignment = 64;

/// Bytes that a planner needs, a constant of the configuration. An upper bound on the core's own layout that this
/// header can state without showing it; the core asserts at compile time that it holds.
constexpr std::size_t kWorkspaceBytes = std::size_t{64} * 1024 * 1024;

/// A block of the right size for a static, a linker section or an arena.
struct alignas(kWorkspaceAlignment) Workspace {
  unsigned char bytes[kWorkspaceBytes];
};

}  // namespace tern

#endif
