// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inflation, 64 voxels a word. A word of the blocked layer depends only on obstacles nearby. So only words near changed
// ones are made again; after bind(), all words count as changed. A row to be made is copied from the plane below if it
// equals the row there.
#include "base/work.hpp"
#include "grid/changes.hpp"
#include "grid/stencil.hpp"
#include "inflation/patch_maker.hpp"
#include "inflation/plane_steps.hpp"
#include "tern/grid.hpp"

namespace tern {
namespace {

/// The rows of a strip that changed in either of two planes, word by word.
struct ChangedRows {
  const std::uint64_t* below;
  const std::uint64_t* above;

  ChangedRows(const Changes& changes, std::int32_t z_below, std::int32_t z_above, std::int32_t strip)
      : below(changes.words_of(z_below, strip)), above(changes.words_of(z_above, strip)) {}
  std::uint64_t at(std::int32_t k) const { return below[k] | above[k]; }
};

/// Adds to reached[k] the rows of the strip that changes in planes `below` and `above` can affect in word k. If the
/// reach is more than 64 rows, whole strips count as reached.
void add_reached(const Changes& changes, std::int32_t below, std::int32_t above, std::int32_t strip, std::int32_t reach,
                 const IndexRange& words, std::uint64_t* reached) {
  if (!changes.plane(below) && !changes.plane(above)) return;
  const std::int32_t far = words_for(reach);
  for (std::int32_t b = strip - far; b <= strip + far && reach >= kStripRows; ++b) {
    const ChangedRows rows(changes, below, above, b);
    for (std::int32_t k = words.begin; k < words.end; ++k) reached[k - words.begin] |= rows.at(k) != 0 ? kAllBits : 0;
  }
  if (reach >= kStripRows) return;
  const ChangedRows before(changes, below, above, strip - 1);
  const ChangedRows own(changes, below, above, strip);
  const ChangedRows after(changes, below, above, strip + 1);
  for (std::int32_t k = words.begin; k < words.end; ++k) {
    if ((before.at(k) | own.at(k) | after.at(k)) == 0) continue;
    reached[k - words.begin] |= spread_bits(before.at(k), own.at(k), after.at(k), reach);
  }
}

/// Marked rows of a strip, for each word of a window.
struct WindowRows {
  std::uint64_t words[kStepWords];

  /// The OR and the AND of all words.
  std::uint64_t any(std::int32_t count) const {
    std::uint64_t any = 0;
    for (std::int32_t k = 0; k < count; ++k) any |= words[k];
    return any;
  }
  std::uint64_t all(std::int32_t count) const {
    std::uint64_t all = kAllBits;
    for (std::int32_t k = 0; k < count; ++k) all &= words[k];
    return all;
  }
};

/// Number of runs of consecutive rows.
std::int32_t count_runs(std::uint64_t rows) {
  std::int32_t runs = 0;
  for (std::uint64_t begins = rows & ~(rows << 1); begins != 0; begins &= begins - 1) ++runs;
  return runs;
}

/// Fills gaps of fewer than 8 rows between runs, and between the last run and the strip's end. Beginning a patch takes
/// longer than making 8 rows. A row that is made without need keeps its content.
std::uint64_t without_gaps(std::uint64_t rows) {
  for (int step = 1; step < 8; step *= 2) rows |= rows << step;
  std::uint64_t gaps = ~rows;
  for (int step = 1; step < 8; step *= 2) gaps |= gaps >> step;
  return ~gaps;
}

/// Number of rows from the first to the last one that is set.
std::int32_t extent_of(std::uint64_t rows) {
  return rows == 0 ? 0 : kStripRows - __builtin_clzll(rows) - __builtin_ctzll(rows);
}

/// Makes the patches of these rows cheaper. Closes small gaps. Gives all words the same rows if one patch for all costs
/// less than one for each word. A patch also takes the words beside it.
void merge(WindowRows& rows, std::int32_t count) {
  std::uint64_t any = 0;
  std::int32_t apart = 0;
  IndexRange words{count, 0};
  for (std::int32_t k = 0; k < count; ++k) {
    rows.words[k] = without_gaps(rows.words[k]);
    any |= rows.words[k];
    apart += 3 * extent_of(rows.words[k]);
    if (rows.words[k] != 0) words = {k < words.begin ? k : words.begin, k + 1};
  }
  if ((words.end - words.begin + 2) * extent_of(any) > apart) return;
  for (std::int32_t k = words.begin; k < words.end; ++k) rows.words[k] = without_gaps(any);
}

/// Removes the first run of rows from word k, and from the following words as long as they contain the whole run. Rows
/// of the patch are counted from the strip's first row, words from the window's first.
Patch take_patch(WindowRows& rows, std::int32_t count, std::int32_t k) {
  const std::int32_t begin = __builtin_ctzll(rows.words[k]);
  const std::uint64_t gaps = ~(rows.words[k] >> begin);
  const std::int32_t length = gaps == 0 ? kStripRows : __builtin_ctzll(gaps);
  const std::uint64_t run = bits_met({begin, begin + length}, 0);
  Patch patch{0, {begin, begin + length}, {k, k}};
  while (patch.words.end < count && (rows.words[patch.words.end] & run) == run) rows.words[patch.words.end++] &= ~run;
  return patch;
}

/// kWidePatch: the cost of a patch that is not narrow, in narrow patches. kFewPatches: only the differences are made if
/// their cost, in narrow patches, exceeds the window's number of words by at most this.
constexpr std::int32_t kWidePatch = 2;
constexpr std::int32_t kFewPatches = 2;

/// One inflation of a grid.
struct Inflation {
  const Changes& changes;
  const Stencil& stencil;
  const PatchMaker& maker;
  Work& work;

  /// The rows of the window that changes can affect in plane z.
  WindowRows find_reached(const StripWindow& window, std::int32_t z) const {
    WindowRows reached{};
    const std::int32_t count = window.words.end - window.words.begin;
    const std::int32_t reach = stencil.gap_z() < 0 ? 0 : stencil.reach(0, 0);
    add_reached(changes, z, z, window.strip, reach, window.words, reached.words);
    for (std::int32_t gap = 0; gap <= stencil.gap_z() && reached.all(count) != kAllBits; ++gap) {
      const std::int32_t reach_there = stencil.reach(gap, 0);
      add_reached(changes, z - gap - 1, z + gap + 1, window.strip, reach_there, window.words, reached.words);
    }
    const std::uint64_t inside = bits_met(maker.rows_inside(), window.strip);
    for (std::int32_t k = 0; k < count; ++k) reached.words[k] &= inside;
    return reached;
  }

  /// Calls `visit` with patches that cover these rows of a plane, and clears `rows`.
  template <typename Visit>
  static void for_each_patch(const StripWindow& window, std::int32_t z, WindowRows& rows, Visit visit) {
    const std::int32_t count = window.words.end - window.words.begin;
    const std::int32_t first = window.strip * kStripRows;
    for (std::int32_t k = 0; k < count; ++k) {
      while (rows.words[k] != 0) {
        const Patch patch = take_patch(rows, count, k);
        visit(Patch{z,
                    {first + patch.rows.begin, first + patch.rows.end},
                    {window.words.begin + patch.words.begin, window.words.begin + patch.words.end}});
      }
    }
  }

  void make_all(const StripWindow& window, std::int32_t z, WindowRows& rows) const {
    const std::int32_t count = window.words.end - window.words.begin;
    merge(rows, count);
    const std::uint64_t inside = bits_met(maker.rows_inside(), window.strip);
    for (std::int32_t k = 0; k < count; ++k) rows.words[k] &= inside;
    for_each_patch(window, z, rows, [this](const Patch& patch) { maker.make(patch, work); });
  }

  /// Makes the voxels of a copied patch that may differ from the plane below.
  void make_differing(const Patch& patch, const PlaneSteps& steps) const {
    const IndexRange x = steps.voxels(patch.words);
    if (!maker.narrow(x)) return maker.make(patch, work);
    maker.make_narrow(patch, x, work);
  }

  /// Makes the rows of `reached` by copying the plane below and making the differences, and removes them from
  /// `reached`. If it is cheaper to make all rows from obstacles, does nothing and returns false.
  bool make_from_below(const StripWindow& window, std::int32_t z, const PlaneSteps& steps, WindowRows& reached) const {
    if (!steps.known()) return false;
    const std::int32_t count = window.words.end - window.words.begin;
    WindowRows differing = reached;
    std::uint64_t equal = 0;
    std::int32_t price = 0;
    for (std::int32_t k = 0; k < count; ++k) {
      const std::int32_t word = window.words.begin + k;
      differing.words[k] &= steps.mark(word).rows;
      equal |= reached.words[k] & ~differing.words[k];
      if (differing.words[k] == 0) continue;
      price += count_runs(differing.words[k]) * (maker.narrow(steps.voxels({word, word + 1})) ? 1 : kWidePatch);
    }
    if (equal == 0 || price > count + kFewPatches) return false;
    for_each_patch(window, z, reached, [this](const Patch& patch) { maker.copy_below(patch, work); });
    for_each_patch(window, z, differing, [&](const Patch& patch) { make_differing(patch, steps); });
    return true;
  }

  /// Makes the rows of one window that changes can affect, plane by plane.
  void make_window(const StripWindow& window, const IndexRange& planes, PlaneSteps& steps) const {
    const std::int32_t count = window.words.end - window.words.begin;
    bool follows = false;
    for (std::int32_t z = planes.begin; z < planes.end; ++z) {
      WindowRows reached = find_reached(window, z);
      work.spend(2 * ops::kPiece + 10 * ops::kWord * count);
      const bool any = reached.any(count) != 0;
      if (any) work.spend(steps.operations(window, follows));
      if (any && follows) steps.advance();
      if (any && !follows) steps.begin(window, z);
      follows = any;
      if (!any) continue;
      const bool copied = make_from_below(window, z, steps, reached);
      steps.judge(copied);
      if (!copied) make_all(window, z, reached);
    }
  }

  /// The rows of the strip that changes in the extent's rows can affect.
  static std::uint64_t rows_reached(const ChangeExtent& extent, std::int32_t strip, std::int32_t reach) {
    const std::int32_t far = words_for(reach);
    const auto rows = [&extent](std::int32_t b) { return b >= 0 && b < kMaxStrips ? extent.rows[b] : 0; };
    if (reach < kStripRows) return spread_bits(rows(strip - 1), rows(strip), rows(strip + 1), reach);
    std::uint64_t any = 0;
    for (std::int32_t b = strip - far; b <= strip + far; ++b) any |= rows(b);
    return any != 0 ? kAllBits : 0;
  }

  /// Makes the part of the blocked layer that changes can affect, in the planes `wanted` and these strips.
  void run(PlaneSteps& steps, const IndexRange& wanted, const IndexRange& strips) const {
    const std::int32_t far_z = stencil.gap_z() + 1;
    const std::int32_t far_y = stencil.gap_z() < 0 ? 0 : stencil.reach(0, 0);
    const ChangeExtent extent =
        changes.extent(overlap({0, changes.planes()}, {wanted.begin - far_z, wanted.end + far_z}));
    const IndexRange reached = overlap(maker.planes_inside(), {extent.planes.begin - far_z, extent.planes.end + far_z});
    const IndexRange planes = overlap(reached, wanted);
    work.spend(ops::kWord * (wanted.end - wanted.begin + 2 * far_z) * changes.strips() * changes.row_words());
    for (std::int32_t strip = strips.begin; strip < strips.end; ++strip) {
      const std::uint64_t any = rows_reached(extent, strip, far_y);
      if (any == 0) continue;
      const IndexRange rows{__builtin_ctzll(any), kStripRows - __builtin_clzll(any)};
      for (std::int32_t k = extent.words.begin; k < extent.words.end; k += kStepWords) {
        make_window({strip, rows, overlap(extent.words, {k, k + kStepWords})}, planes, steps);
      }
    }
  }
};

}  // namespace

void Grid::inflate_planes(std::int32_t begin, std::int32_t end, std::int32_t first_strip, std::int32_t end_strip,
                          Work& work) noexcept {
  const Changes changes(spec_.dims, changes_);
  work.spend(ops::kPiece);
  if (!changes.any()) return;
  work.spend(kStencilOperations);
  const Stencil stencil(spec_);
  const PatchMaker maker(*this, stencil, blocked_);
  PlaneSteps steps(*this, stencil);
  Inflation{changes, stencil, maker, work}.run(steps, {begin, end}, {first_strip, end_strip});
}

Operations inflation_operations(const Grid& grid) noexcept {
  const Stencil stencil(grid.spec());
  const PatchMaker maker(grid, stencil, nullptr);
  const PlaneSteps steps(grid, stencil);
  const Voxel& dims = grid.spec().dims;
  const std::int32_t strips = words_for(dims.y);
  const StripWindow widest{0, {0, kStripRows}, {0, kStepWords}};
  const Operations window =
      2 * ops::kPiece + steps.operations(widest, false) + kStepWords * (10 * ops::kWord + maker.most_operations());
  const Operations piece = ops::kPiece + kStencilOperations +
                           ops::kWord * (kStripRows + 2 * (stencil.gap_z() + 1)) * strips * words_for(dims.x);
  return (piece + window * words_for(words_for(dims.x) * kWordBits / kStepWords + kWordBits)) * strips * dims.z;
}

void Grid::inflate() noexcept {
  if (!bound()) return;
  Work work;
  inflate_planes(0, spec_.dims.z, 0, words_for(spec_.dims.y), work);
  Changes changes(spec_.dims, changes_);
  if (changes.any()) changes.clear();
  words_[kInflated] = words_[kRevision];
}

}  // namespace tern
