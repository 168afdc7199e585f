// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inflation/plane_steps.hpp"

#include "base/work.hpp"
#include "grid/changes.hpp"

namespace tern {
namespace {

/// Rows that are compared at once, since most are equal.
constexpr std::int32_t kRowsCompared = 8;

/// True if any of the words differ.
bool differ(const std::uint64_t* a, const std::uint64_t* b, std::int32_t count) {
  std::uint64_t difference = 0;
  for (std::int32_t k = 0; k < count; ++k) difference |= a[k] ^ b[k];
  return difference != 0;
}

/// Adds these rows and bits to the mark; adds nothing if there are no bits.
void add(WordMark& mark, std::uint64_t rows, std::uint64_t bits) {
  if (bits == 0) return;
  mark.rows |= rows;
  mark.bits |= bits;
}

void clear(WordMark* marks) {
  for (std::int32_t k = 0; k < kStepWords; ++k) marks[k] = {0, 0};
}

}  // namespace

PlaneSteps::PlaneSteps(const Grid& grid, const Stencil& stencil)
    : obstacles_(GridAccess::obstacles(grid)),
      dims_(grid.spec().dims),
      reach_x_(stencil.gap_x() + 1),
      reach_y_(stencil.gap_z() < 0 ? 0 : stencil.reach(0, 0)),
      reach_z_(stencil.gap_z() + 1) {}

void PlaneSteps::begin(const StripWindow& window, std::int32_t z) {
  window_ = window;
  z_ = z;
  known_ = false;
  useless_ = rest_ = 0;
  if (!followed()) return;
  for (std::int32_t p = 0; p < kStepPlanes; ++p) clear(marks_[p]);
  for (std::int32_t step = z + 1 - reach_z_; step <= z + reach_z_; ++step) take(step);
}

void PlaneSteps::advance() {
  if (!followed()) return;
  if (rest_ == 1) return begin(window_, z_ + 1);
  clear(marks_[z_ % kStepPlanes]);
  ++z_;
  known_ = rest_ == 0;
  if (rest_ > 0) --rest_;
  if (known_) take(z_ + reach_z_);
}

Operations PlaneSteps::operations(const StripWindow& window, bool follows) const {
  const int words = (window.rows.end - window.rows.begin + 2 * reach_y_) * (window.words.end - window.words.begin + 2);
  return (2 * ops::kPiece + 2 * ops::kWord * words) * (follows ? 1 : 2 * reach_z_);
}

void PlaneSteps::judge(bool useful) {
  if (!known_) return;
  useless_ = useful ? 0 : useless_ + 1;
  // One slab makes this many planes differ: reach_z_ at its bottom, and as many at its top.
  if (useless_ > 2 * reach_z_) rest_ = kRestPlanes;
}

/// True if the rows of planes step - 1 and step differ in the window or in a word next to it.
bool PlaneSteps::rows_differ(const IndexRange& rows, std::int32_t step) const {
  const IndexRange words = overlap({0, obstacles_.row_words}, {window_.words.begin - 1, window_.words.end + 1});
  const std::int32_t width = words.end - words.begin;
  const std::uint64_t* row = obstacles_.row(rows.begin, step) + words.begin;
  const std::uint64_t* below = row - obstacles_.index(0, 1);
  const std::int32_t count = rows.end - rows.begin;
  if (width == obstacles_.row_words) return differ(row, below, count * width);
  for (std::int32_t r = 0; r < count; ++r) {
    if (differ(row + r * obstacles_.row_words, below + r * obstacles_.row_words, width)) return true;
  }
  return false;
}

/// Marks the voxels that the difference between planes step - 1 and step may change. Planes past the grid count as
/// copies of the outermost one, whose obstacles are nearer.
void PlaneSteps::take(std::int32_t step) {
  if (step < 1 || step >= dims_.z) return;
  const std::int32_t first = window_.strip * kStripRows;
  const IndexRange rows =
      overlap({0, dims_.y}, {first + window_.rows.begin - reach_y_, first + window_.rows.end + reach_y_});
  if (!rows_differ(rows, step)) return;
  Differences appearing{};
  Differences vanishing{};
  for (std::int32_t y = rows.begin; y < rows.end; y += kRowsCompared) {
    const IndexRange some = overlap(rows, {y, y + kRowsCompared});
    if (!rows_differ(some, step)) continue;
    for (std::int32_t r = some.begin; r < some.end; ++r) {
      add_row(obstacles_.row(r, step), r, appearing, vanishing);
    }
  }
  mark_planes(step - reach_z_, step, appearing);
  mark_planes(step + 1, step + reach_z_ + 1, vanishing);
}

/// Adds the differences in one row, for all rows of the strip that they can affect.
void PlaneSteps::add_row(const std::uint64_t* row, std::int32_t y, Differences& appearing,
                         Differences& vanishing) const {
  const std::uint64_t* below = row - obstacles_.index(0, 1);
  const std::int32_t at = y - window_.strip * kStripRows;
  const std::int32_t first = window_.words.begin - 1;
  const IndexRange words = overlap({0, obstacles_.row_words}, {first, window_.words.end + 1});
  std::uint64_t rows = 0;
  for (std::int32_t k = words.begin; k < words.end; ++k) {
    const std::uint64_t changed = row[k] ^ below[k];
    if (changed == 0) continue;
    if (rows == 0) rows = bits_met({at - reach_y_, at + reach_y_ + 1}, 0);
    add(appearing.words[k - first], rows, row[k] & changed);
    add(vanishing.words[k - first], rows, below[k] & changed);
  }
}

/// Marks the voxels that the differences can affect along x, in planes begin .. end - 1, but not in planes that are
/// done.
void PlaneSteps::mark_planes(std::int32_t begin, std::int32_t end, const Differences& differences) {
  for (std::int32_t k = 0; k < window_.words.end - window_.words.begin; ++k) {
    const WordMark* words = differences.words + k;
    WordMark reached{0, spread_bits(words[0].bits, words[1].bits, words[2].bits, reach_x_)};
    if (reached.bits == 0) continue;
    if ((words[0].bits & ~(kAllBits >> reach_x_)) != 0) reached.rows |= words[0].rows;
    if (words[1].bits != 0) reached.rows |= words[1].rows;
    if ((words[2].bits & bits_before(reach_x_)) != 0) reached.rows |= words[2].rows;
    for (std::int32_t z = begin < z_ ? z_ : begin; z < end; ++z) {
      add(marks_[z % kStepPlanes][k], reached.rows, reached.bits);
    }
  }
}

}  // namespace tern
