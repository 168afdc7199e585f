// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The evidence of a map about 64 voxels, and its change by hits and misses. Each operation on words handles all 64 at
// once.
#ifndef TERN_MAP_EVIDENCE_HPP
#define TERN_MAP_EVIDENCE_HPP

#include <cstdint>

namespace tern {

/// Four words with one bit for each voxel. `low` and `high` are the two bits of a count: of hits while the voxel is
/// clear, of misses while it is blocked.
struct Evidence {
  std::uint64_t seen;
  std::uint64_t low;
  std::uint64_t high;
  std::uint64_t blocked;
};

/// The count at which one more hit blocks a voxel, or one more miss clears it: the same number, 0 .. 3, in all 64
/// voxels.
struct Threshold {
  std::uint64_t low;
  std::uint64_t high;

  explicit Threshold(std::int32_t times) noexcept
      : low(((times - 1) & 1) != 0 ? ~std::uint64_t{0} : 0), high(((times - 1) & 2) != 0 ? ~std::uint64_t{0} : 0) {}

  std::uint64_t reached(const Evidence& e) const noexcept { return ~(e.low ^ low) & ~(e.high ^ high); }
};

/// Enters a frame. A voxel that is both hit and missed counts as hit. In a clear voxel, a hit adds one to the count and
/// a miss subtracts one. In a blocked voxel, a miss adds one and a hit resets the count to 0. When the count reaches
/// its threshold, the voxel becomes blocked or clear, and the count starts again from 0. A missed voxel counts as seen.
inline Evidence after(const Evidence& e, std::uint64_t hit, std::uint64_t miss, const Threshold& hits,
                      const Threshold& misses) noexcept {
  miss &= ~hit;
  const std::uint64_t flips = (hit & ~e.blocked & hits.reached(e)) | (miss & e.blocked & misses.reached(e));
  const std::uint64_t up = ((hit & ~e.blocked) | (miss & e.blocked)) & ~flips;
  const std::uint64_t down = miss & ~e.blocked & (e.low | e.high);
  const std::uint64_t reset = flips | (hit & e.blocked);
  const std::uint64_t carry = up & e.low;
  const std::uint64_t borrow = down & ~e.low;
  return {e.seen | miss, (e.low ^ up ^ down) & ~reset, (e.high ^ carry ^ borrow) & ~reset, e.blocked ^ flips};
}

/// The voxels that a miss would change.
inline std::uint64_t open_to_misses(const Evidence& e) noexcept {
  return ~e.seen | e.blocked | e.low | e.high;
}

/// The voxels that a miss would change without taking anything away from hits.
inline std::uint64_t open_to_sight(const Evidence& e) noexcept {
  return ~(e.seen | e.blocked | e.low | e.high);
}

}  // namespace tern

#endif
