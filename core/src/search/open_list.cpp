// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/open_list.hpp"

namespace tern {
namespace {

constexpr std::int32_t kArity = 4;
constexpr std::uint32_t kBinWords = kBins / 64;
constexpr std::uint32_t kBinGroups = kBinWords / 64;
static_assert(kBinGroups >= 1, "the ring is whole groups of words of bins");

/// The most entries that one call moves from a bin to the heap.
constexpr int kMovedAtOnce = 256;

std::uint64_t bin_of(Cost f) {
  return f >> kBinBits;
}

OpenEntry entry_of(const OpenKey& key, std::uint32_t node) {
  return {key.f << (64 - kBinBits) | key.tie >> 32, static_cast<std::uint32_t>(key.tie), node};
}

bool before(const OpenEntry& a, const OpenEntry& b) {
  return a.order != b.order ? a.order < b.order : a.voxel < b.voxel;
}

// ---- the heap

/// Moves the hole at `at` towards the root until `entry` fits into it, and fills it. The heap's depth bounds the loop.
void rise(OpenList& open, std::int32_t at, const OpenEntry& entry) {
  while (at > 0) {
    const std::int32_t up = (at - 1) / kArity;
    if (!before(entry, open.heap[up])) break;
    open.heap[at] = open.heap[up];
    at = up;
  }
  open.heap[at] = entry;
}

std::int32_t first_child(const OpenList& open, std::int32_t begin) {
  const std::int32_t end = begin + kArity < open.heap_count ? begin + kArity : open.heap_count;
  std::int32_t least = begin;
  for (std::int32_t k = begin + 1; k < end; ++k) {
    if (before(open.heap[k], open.heap[least])) least = k;
  }
  return least;
}

/// Moves the hole at the root towards the leaves until `entry` fits into it, and fills it.
void sink(OpenList& open, const OpenEntry& entry) {
  std::int32_t at = 0;
  while (at * kArity + 1 < open.heap_count) {
    const std::int32_t child = first_child(open, at * kArity + 1);
    if (!before(open.heap[child], entry)) break;
    open.heap[at] = open.heap[child];
    at = child;
  }
  open.heap[at] = entry;
}

/// Puts an entry into the heap: into the place of the first entry, if that was just taken. A successor of the node
/// taken often precedes all other entries, and then stays there.
void put_in_heap(OpenList& open, const OpenEntry& entry) {
  if (!open.hole) return rise(open, open.heap_count++, entry);
  open.hole = false;
  sink(open, entry);
}

void fill_hole(OpenList& open) {
  if (!open.hole) return;
  open.hole = false;
  --open.heap_count;
  if (open.heap_count > 0) sink(open, open.heap[open.heap_count]);
}

// ---- the bins

bool word_is_busy(const OpenList& open, std::uint32_t word) {
  return (open.groups[word / 64] >> (word % 64) & 1u) != 0;
}

/// Marks the bin as busy. True if it was busy before.
bool mark_busy(OpenList& open, std::uint32_t bin) {
  const std::uint32_t word = bin / 64;
  const std::uint64_t bit = std::uint64_t{1} << (bin % 64);
  const std::uint64_t others = word_is_busy(open, word) ? open.busy[word] : 0;
  open.groups[word / 64] |= std::uint64_t{1} << (word % 64);
  open.busy[word] = others | bit;
  return (others & bit) != 0;
}

void mark_empty(OpenList& open, std::uint32_t bin) {
  const std::uint32_t word = bin / 64;
  open.busy[word] &= ~(std::uint64_t{1} << (bin % 64));
  if (open.busy[word] == 0) open.groups[word / 64] &= ~(std::uint64_t{1} << (word % 64));
}

/// The first busy bin of the ring from `from` on. There must be one.
std::uint32_t next_busy(const OpenList& open, std::uint32_t from) {
  std::uint32_t word = from / 64;
  if (word_is_busy(open, word)) {
    const std::uint64_t bins = open.busy[word] & ~std::uint64_t{0} << (from % 64);
    if (bins != 0) return word * 64 + static_cast<std::uint32_t>(__builtin_ctzll(bins));
  }
  word = (word + 1) % kBinWords;
  std::uint64_t words = open.groups[word / 64] & ~std::uint64_t{0} << (word % 64);
  std::uint32_t group = word / 64;
  // Goes once around the ring, at last to the other words of the first group.
  for (std::uint32_t k = 0; k < kBinGroups && words == 0; ++k) {
    group = (group + 1) % kBinGroups;
    words = open.groups[group];
  }
  word = group * 64 + static_cast<std::uint32_t>(__builtin_ctzll(words));
  return word * 64 + static_cast<std::uint32_t>(__builtin_ctzll(open.busy[word]));
}

void put_in_bin(OpenList& open, std::uint32_t bin, std::uint32_t node) {
  std::int32_t link = open.unused;
  if (link == kNoLink) {
    link = open.links_used++;
  } else {
    open.unused = open.links[link].next;
  }
  open.links[link] = {node, mark_busy(open, bin) ? open.first[bin] : kNoLink};
  open.first[bin] = link;
}

/// Goes on to the next busy bin. There must be one.
void next_bin(OpenList& open) {
  const auto bin = static_cast<std::uint32_t>(open.bin % kBins);
  const std::uint32_t next = next_busy(open, (bin + 1) % kBins);
  open.bin += (next - bin) % kBins;
  open.moving = open.first[next];
  mark_empty(open, next);
}

/// Moves a link from the heap's bin to the heap, or drops it if a better path to its node has made it outdated.
void move_link(OpenList& open, const NodeStore& store, const Voxel& goal) {
  const std::int32_t link = open.moving;
  const std::uint32_t index = open.links[link].node;
  open.moving = open.links[link].next;
  open.links[link].next = open.unused;
  open.unused = link;
  const SearchNode& node = store.nodes[index];
  const OpenKey key = open_key(node.g, octile(node.at(), goal), node.voxel);
  if (node.open != 0 && bin_of(key.f) == open.bin) {
    rise(open, open.heap_count++, entry_of(key, index));
  } else {
    --open.count;
  }
}

}  // namespace

void open_reset(OpenList& open, Cost f) noexcept {
  open.count = 0;
  open.high = 0;
  open.heap_count = 0;
  open.hole = false;
  open.links_used = 0;
  open.unused = kNoLink;
  open.moving = kNoLink;
  open.bin = bin_of(f);
  for (std::uint64_t& group : open.groups) group = 0;
}

bool open_put(OpenList& open, NodeStore& store, std::uint32_t node, const OpenKey& key) noexcept {
  if (open.count == kMaxOpen) return false;
  ++open.count;
  if (open.count > open.high) open.high = open.count;
  store.nodes[node].open = 1;
  const std::uint64_t bin = bin_of(key.f);
  if (bin == open.bin) {
    put_in_heap(open, entry_of(key, node));
  } else {
    put_in_bin(open, static_cast<std::uint32_t>(bin % kBins), node);
  }
  return true;
}

bool open_ready(OpenList& open, const NodeStore& store, const Voxel& goal) noexcept {
  fill_hole(open);
  if (open.count == 0) return false;
  if (open.heap_count == 0 && open.moving == kNoLink) next_bin(open);
  for (int k = 0; k < kMovedAtOnce && open.moving != kNoLink; ++k) move_link(open, store, goal);
  return open.heap_count > 0 && open.moving == kNoLink;
}

std::uint32_t open_take(OpenList& open, NodeStore& store, Cost& f) noexcept {
  const OpenEntry taken = open.heap[0];
  --open.count;
  open.hole = true;
  SearchNode& node = store.nodes[taken.node];
  if (node.open == 0) return static_cast<std::uint32_t>(kMaxNodes);
  node.open = 0;
  f = open.bin << kBinBits | taken.order >> (64 - kBinBits);
  return taken.node;
}

}  // namespace tern
