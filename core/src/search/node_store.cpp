// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/node_store.hpp"

namespace tern {
namespace {

constexpr std::uint32_t kPages = kNodeSlots / kPageSlots;

/// The voxel's slot, unless another voxel has taken it.
std::uint32_t home_slot(const Voxel& v) {
  return page_hash(page_coordinates(v), kPages) * kPageSlots + static_cast<std::uint32_t>(place_in_page(v));
}

/// Clears the 64 slots of a page that this search has not looked at yet.
void clear_page(NodeStore& store, std::uint32_t page) {
  store.cleared[page / 64] |= std::uint64_t{1} << (page % 64);
  std::uint32_t* slots = store.slots + page * kPageSlots;
  for (std::uint32_t k = 0; k < kPageSlots; ++k) slots[k] = 0;
}

}  // namespace

void store_reset(NodeStore& store, const Voxel& dims) noexcept {
  store.count = 0;
  store.nx = static_cast<std::uint32_t>(dims.x);
  store.ny = static_cast<std::uint32_t>(dims.y);
  for (std::uint64_t& word : store.cleared) word = 0;
}

std::uint32_t store_find_or_add(NodeStore& store, const Voxel& voxel) noexcept {
  const std::uint32_t row = static_cast<std::uint32_t>(voxel.y) + store.ny * static_cast<std::uint32_t>(voxel.z);
  const std::uint32_t number = static_cast<std::uint32_t>(voxel.x) + store.nx * row;
  std::uint32_t slot = home_slot(voxel);
  // Ends at a free slot at the latest: no more than half of them are used.
  for (;; slot = (slot + 1) % kNodeSlots) {
    const std::uint32_t page = slot / kPageSlots;
    if ((store.cleared[page / 64] >> (page % 64) & 1u) == 0) clear_page(store, page);
    const std::uint32_t held = store.slots[slot];
    if (held == 0) break;
    if (store.nodes[held - 1].voxel == number) return held - 1;
  }
  if (store.count == static_cast<std::uint32_t>(kMaxNodes)) return store.count;
  const std::uint32_t index = store.count++;
  store.slots[slot] = index + 1;
  store.nodes[index] = {0,
                        static_cast<std::int16_t>(voxel.x),
                        static_cast<std::int16_t>(voxel.y),
                        static_cast<std::int16_t>(voxel.z),
                        0,
                        number,
                        index,
                        0,
                        0};
  return index;
}

}  // namespace tern
