// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/open_list.hpp"

namespace tern {
namespace {

constexpr std::int32_t kArity = 4;

void place(OpenList& open, NodeStore& store, std::int32_t at, const OpenKey& key, std::uint32_t node) {
  open.keys[at] = key;
  open.owners[at] = node;
  store.nodes[node].open_slot = at;
}

/// Moves the hole at `at` towards the root until `key` fits into it, and fills it. The heap's depth bounds the loop.
void rise(OpenList& open, NodeStore& store, std::int32_t at, const OpenKey& key, std::uint32_t node) {
  while (at > 0) {
    const std::int32_t up = (at - 1) / kArity;
    if (!before(key, open.keys[up])) break;
    place(open, store, at, open.keys[up], open.owners[up]);
    at = up;
  }
  place(open, store, at, key, node);
}

std::int32_t first_child(const OpenList& open, std::int32_t at) {
  const std::int32_t begin = at * kArity + 1;
  const std::int32_t end = begin + kArity < open.count ? begin + kArity : open.count;
  std::int32_t least = begin;
  for (std::int32_t k = begin + 1; k < end; ++k) {
    if (before(open.keys[k], open.keys[least])) least = k;
  }
  return least;
}

/// Moves the hole at the root towards the leaves until `key` fits into it, and fills it.
void sink(OpenList& open, NodeStore& store, const OpenKey& key, std::uint32_t node) {
  std::int32_t at = 0;
  while (at * kArity + 1 < open.count) {
    const std::int32_t child = first_child(open, at);
    if (!before(open.keys[child], key)) break;
    place(open, store, at, open.keys[child], open.owners[child]);
    at = child;
  }
  place(open, store, at, key, node);
}

}  // namespace

void open_reset(OpenList& open) noexcept {
  open.count = 0;
  open.high = 0;
}

bool open_put(OpenList& open, NodeStore& store, std::uint32_t node, const OpenKey& key) noexcept {
  std::int32_t at = store.nodes[node].open_slot;
  if (at == kNotOpen) {
    if (open.count == kMaxHeap) return false;
    at = open.count++;
    if (open.count > open.high) open.high = open.count;
  }
  rise(open, store, at, key, node);
  return true;
}

std::uint32_t open_take(OpenList& open, NodeStore& store) noexcept {
  const std::uint32_t node = open.owners[0];
  store.nodes[node].open_slot = kNotOpen;
  --open.count;
  if (open.count > 0) sink(open, store, open.keys[open.count], open.owners[open.count]);
  return node;
}

}  // namespace tern
