// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A priority queue of small integers: a ring of buckets, last in first out within a bucket.
#ifndef TERN_GUIDE_BUCKET_QUEUE_HPP
#define TERN_GUIDE_BUCKET_QUEUE_HPP

#include <cstdint>

#include "tern/config.hpp"

namespace tern {

/// At most kEntries entries, in a ring of kBuckets buckets (a multiple of 64). An entry that belongs kBuckets or more
/// beyond the current bucket goes into the last bucket of the ring, and comes out too early. The same can happen to
/// entries in the ring after the current bucket has gone back. The caller therefore compares the bucket of each entry
/// that it takes with the current one, and puts entries that are early in again. Plain data; needs no initialisation
/// before queue_reset.
template <std::int32_t kBuckets, std::int32_t kEntries>
struct BucketQueue {
  struct Entry {
    std::uint32_t item;
    std::int32_t next;  ///< next in its bucket, -1 at the end; or next one to reuse, `used` at the end
  };
  std::uint32_t current;  ///< bucket that the last entry came from
  std::int32_t count;
  std::int32_t used;    ///< entries that have ever been used
  std::int32_t unused;  ///< first entry to reuse; `used` if there is none
  std::uint64_t busy[kBuckets / 64];
  std::int32_t first[kBuckets];  ///< first entry of each bucket; -1 if there is none
  Entry entries[kEntries];
};

template <std::int32_t kBuckets, std::int32_t kEntries>
void queue_reset(BucketQueue<kBuckets, kEntries>& queue) noexcept {
  queue.current = 0;
  queue.count = 0;
  queue.used = 0;
  queue.unused = 0;
  for (std::uint64_t& word : queue.busy) word = 0;
  for (std::int32_t& entry : queue.first) entry = -1;
}

/// Puts an item into a bucket. False if the queue is full.
template <std::int32_t kBuckets, std::int32_t kEntries>
bool queue_put(BucketQueue<kBuckets, kEntries>& queue, std::uint32_t bucket, std::uint32_t item) noexcept {
  if (queue.count == kEntries) return false;
  if (queue.count++ == 0 || bucket < queue.current) queue.current = bucket;
  const std::uint32_t beyond = bucket - queue.current;
  const std::uint32_t slot = (beyond < kBuckets ? bucket : queue.current + kBuckets - 1) % kBuckets;
  const std::int32_t entry = queue.unused;
  queue.unused = entry == queue.used ? ++queue.used : queue.entries[entry].next;
  queue.entries[entry] = {item, queue.first[slot]};
  queue.first[slot] = entry;
  queue.busy[slot / 64] |= std::uint64_t{1} << (slot % 64);
  return true;
}

/// Takes the last entry of the first bucket that is not empty. This becomes the current bucket. The queue must not be
/// empty.
template <std::int32_t kBuckets, std::int32_t kEntries>
std::uint32_t queue_take(BucketQueue<kBuckets, kEntries>& queue) noexcept {
  constexpr std::uint32_t kWords = kBuckets / 64;
  const std::uint32_t from = queue.current % kBuckets;
  std::uint32_t word = from / 64;
  std::uint64_t bits = queue.busy[word] & ~std::uint64_t{0} << (from % 64);
  for (std::uint32_t k = 0; bits == 0 && k < kWords; ++k) {
    word = (word + 1) % kWords;
    bits = queue.busy[word];
  }
  const std::uint32_t slot = word * 64 + static_cast<std::uint32_t>(__builtin_ctzll(bits));
  queue.current += (slot - from) % kBuckets;
  const std::int32_t entry = queue.first[slot];
  queue.first[slot] = queue.entries[entry].next;
  if (queue.first[slot] < 0) queue.busy[word] &= ~(std::uint64_t{1} << (slot % 64));
  queue.entries[entry].next = queue.unused;
  queue.unused = entry;
  --queue.count;
  return queue.entries[entry].item;
}

}  // namespace tern

#endif
