// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PROVE_ASKED_FENCES_HPP
#define TERN_PROVE_ASKED_FENCES_HPP

#include <cstdint>

#include "tern/config.hpp"
#include "tern/fence.hpp"

namespace tern {

/// A request's fences as the caller gave them, for the check: world frame, normals of any length. The fences point into
/// `planes`, so they may not move.
struct AskedFences {
  std::int32_t count;
  Fence fence[kMaxFences];
  Halfspace planes[kMaxFencePlanes];
};

/// Copies the caller's fences, which load_fences has accepted. False if they are too many.
bool copy_fences(const Fence* list, std::int32_t count, AskedFences& asked) noexcept;

}  // namespace tern

#endif
