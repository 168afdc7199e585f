// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/node_store.hpp"

namespace tern {
namespace {

/// Multiplicative hashing by the golden ratio, upper bits.
std::uint32_t home_slot(const NodeStore& store, std::uint32_t voxel) {
  return (voxel * 0x9E3779B1u) >> (32 - store.slot_bits);
}

}  // namespace

void store_reset(NodeStore& store, std::int64_t voxels) noexcept {
  const std::int64_t most = voxels < kMaxNodes ? voxels : kMaxNodes;
  store.count = 0;
  store.slot_bits = 1;
  while (std::int64_t{1} << store.slot_bits < 2 * most) ++store.slot_bits;
}

std::uint32_t store_find_or_add(NodeStore& store, std::uint32_t voxel) noexcept {
  const std::uint32_t mask = (std::uint32_t{1} << store.slot_bits) - 1;
  std::uint32_t slot = home_slot(store, voxel);
  // Ends at an unused slot at the latest: no more than half of them are used.
  for (;; slot = (slot + 1) & mask) {
    const std::uint32_t index = store.slots[slot];
    if (index >= store.count || store.nodes[index].slot != slot) break;
    if (store.nodes[index].voxel == voxel) return index;
  }
  if (store.count == static_cast<std::uint32_t>(kMaxNodes)) return store.count;
  const std::uint32_t index = store.count++;
  store.slots[slot] = index;
  store.nodes[index] = {0, voxel, index, 0, 0, slot, kNotOpen};
  return index;
}

}  // namespace tern
