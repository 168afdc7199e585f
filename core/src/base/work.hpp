// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The prices of primitives. A piece of work spends the operations of its primitives, times sizes and turns that it
// knows anyway: `work.spend(ops::kDot * planes)`. It calls spend() once a loop, never in an innermost turn.
#ifndef TERN_BASE_WORK_HPP
#define TERN_BASE_WORK_HPP

#include <cstdint>

#include "tern/work.hpp"

namespace tern {

using Operations = std::int64_t;

/// Operations of the primitives that all loops are made of, counted from their instructions on aarch64. The timing gate
/// compares units with instructions, stage by stage (docs/timing.md).
namespace ops {

/// A multiply-add, not contracted: a load, a multiplication and an addition.
constexpr Operations kMultiplyAdd = 3;
/// An element of a dense loop that takes two doubles at a time: half of two loads, a multiplication, an addition and a
/// store.
constexpr Operations kElement = 2;
/// A turn that copies, compares or clears one record: the loads, the stores, and the branch.
constexpr Operations kTurn = 8;
/// A word of a layer of voxels: read, masked or combined, and tested or written.
constexpr Operations kWord = 5;
/// A point against a half-space, or its three coordinates against a box: three multiply-adds, the loads of both, and
/// the comparison.
constexpr Operations kDot = 15;
/// A row of voxels: its address, the range of its words from coordinates, and its first word.
constexpr Operations kRow = 60;
/// A piece, besides its loops: the calls and switches that lead to it, its state read and written.
constexpr Operations kPiece = 200;
/// A voxel, node or block of a search: its record found, read and written, and its place in a queue.
constexpr Operations kNode = 180;
/// A curve of degree 7: its eight control points made or read once, with eight multiply-adds on each of three axes.
constexpr Operations kCurve = 8 * 8 * 3 * kMultiplyAdd;

}  // namespace ops

constexpr std::uint32_t least(std::uint32_t a, std::uint32_t b) noexcept {
  return b < a ? b : a;
}

/// Raises a high-water mark to `value`, if that is higher.
inline void raise(std::int32_t& mark, std::int32_t value) noexcept {
  if (mark < value) mark = value;
}

/// The part of some work that a job may spend. When the share ends, the whole pays for the job.
class Share {
 public:
  Share(Work& whole, Operations most) noexcept : part(whole.within(most)), whole_(&whole), given_(part.operations()) {}
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;
  ~Share() noexcept { whole_->spend(spent()); }
  Operations spent() const noexcept { return given_ - part.operations(); }

  Work part;

 private:
  Work* whole_;
  Operations given_;
};

}  // namespace tern

#endif
