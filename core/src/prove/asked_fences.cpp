// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/asked_fences.hpp"

namespace tern {

bool copy_fences(const Fence* list, std::int32_t count, AskedFences& asked) noexcept {
  asked.count = 0;
  if (count > kMaxFences) return false;
  std::int32_t planes = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    if (list[i].count > kMaxFencePlanes - planes) return false;
    asked.fence[i] = {asked.planes + planes, list[i].count, list[i].kind};
    for (std::int32_t p = 0; p < list[i].count; ++p) asked.planes[planes++] = list[i].planes[p];
  }
  asked.count = count;
  return true;
}

}  // namespace tern
