// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/page_store.hpp"

namespace tern {

void page_store_reset(PageStore& store) noexcept {
  store.count = 0;
  for (std::uint16_t& slot : store.slots) slot = 0;
}

std::int32_t page_find_or_add(PageStore& store, const Voxel& voxel) noexcept {
  const Voxel at{voxel.x >> 2, voxel.y >> 2, voxel.z >> 2};
  const auto key = static_cast<std::uint32_t>(at.x | at.y << 10 | at.z << 20);
  // The upper bits of multiplicative hashing by the golden ratio.
  auto slot = static_cast<std::uint32_t>(std::uint64_t{key * 0x9E3779B1u} * kPageSlots >> 32);
  // Ends at a free slot at the latest, because at most half of the slots are used.
  for (; store.slots[slot] != 0; slot = (slot + 1) % kPageSlots) {
    const std::int32_t held = store.slots[slot] - 1;
    if (same(store.pages[held].at, at)) return held;
  }
  if (store.count == kGuidePages) return kGuidePages;
  Page& page = store.pages[store.count];
  page.reached = 0;
  page.closed = 0;
  page.at = at;
  page.heads = false;
  store.slots[slot] = static_cast<std::uint16_t>(store.count + 1);
  return store.count++;
}

}  // namespace tern
