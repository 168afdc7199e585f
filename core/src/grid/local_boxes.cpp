// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid/local_boxes.hpp"

#include <cstddef>

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

constexpr double kFullyInside = 1.0 - kLatticeTolerance;

/// Truncates to [0, count]. Compares as doubles first, because a far coordinate does not fit into an integer.
std::int32_t clamp_index(double cells, std::int32_t count) {
  if (!(cells > 0.0)) return 0;
  if (cells >= static_cast<double>(count)) return count;
  return static_cast<std::int32_t>(cells);
}

/// The words of a row that hold the range, with masks for the first and the last of them.
struct Window {
  std::int32_t first_word;
  std::int32_t words;
  std::uint64_t first_mask;
  std::uint64_t last_mask;
};

Window window_of(const VoxelRange& range) {
  const std::int32_t first = range.lower.x >> 6;
  const std::int32_t last = (range.upper.x - 1) >> 6;
  const IndexRange bits{range.lower.x, range.upper.x};
  return {first, last - first + 1, bits_within(bits, first), bits_within(bits, last)};
}

/// One layer's rows of the range: row y begins `y * stride` words after `words`.
struct Rows {
  const std::uint64_t* words;
  std::int32_t stride;
  std::int32_t count;
};

Rows rows_of(const Grid& grid, const VoxelRange& range, const Window& window, std::int32_t z) {
  const BitRows rows = GridAccess::obstacles(grid);
  return {rows.row(range.lower.y, z) + window.first_word, rows.row_words, range.upper.y - range.lower.y};
}

/// For kWords words of the window from `first` on, ORs the bits in which the rows differ from the rows `back` words
/// before them.
template <std::int32_t kWords>
void add_differences(const Rows& rows, std::ptrdiff_t back, std::int32_t first, std::uint64_t* differences) {
  const std::uint64_t* row = rows.words + first;
  const std::ptrdiff_t next = rows.stride;
  std::uint64_t any[kWords] = {};
  std::int32_t y = 0;
  for (; y + 1 < rows.count; y += 2, row += 2 * next) {
    for (std::int32_t k = 0; k < kWords; ++k)
      any[k] |= (row[k] ^ row[k - back]) | (row[next + k] ^ row[next + k - back]);
  }
  if (y < rows.count) {
    for (std::int32_t k = 0; k < kWords; ++k) any[k] |= row[k] ^ row[k - back];
  }
  for (std::int32_t k = 0; k < kWords; ++k) differences[first + k] = any[k];
}

/// True if all rows have the same bits in the window as the rows `back` words before them. In a map of cuboids, most
/// layers equal the one below, so the extraction spends most of its time here. `differences` has a word for each word
/// of the window.
bool all_equal(const Rows& rows, const Window& window, std::ptrdiff_t back, std::uint64_t* differences) {
  std::int32_t k = 0;
  for (; k + 1 < window.words; k += 2) add_differences<2>(rows, back, k, differences);
  if (k < window.words) add_differences<1>(rows, back, k, differences);
  differences[0] &= window.first_mask;
  differences[window.words - 1] &= window.last_mask;
  std::uint64_t any = 0;
  for (k = 0; k < window.words; ++k) any |= differences[k];
  return any == 0;
}

/// The first row at or after `y` whose bits in the window differ from those of the row before, or rows.count.
std::int32_t first_difference(const Rows& rows, const Window& window, std::int32_t y) {
  const std::int32_t last = window.words - 1;
  const std::ptrdiff_t back = rows.stride;
  const std::uint64_t* row = rows.words + y * back;
  for (; y < rows.count; ++y, row += back) {
    std::uint64_t difference = ((row[0] ^ row[-back]) & window.first_mask);
    difference |= ((row[last] ^ row[last - back]) & window.last_mask);
    for (std::int32_t k = 1; k < last; ++k) difference |= row[k] ^ row[k - back];
    if (difference != 0) break;
  }
  return y;
}

void copy_window(const std::uint64_t* row, const Window& window, std::uint64_t* out) {
  for (std::int32_t k = 0; k < window.words; ++k) out[k] = row[k];
  out[0] &= window.first_mask;
  out[window.words - 1] &= window.last_mask;
}

/// The next run of set bits at or after `x`, as [x, end); false if there is none among the first `count` bits.
bool next_run(const std::uint64_t* row, std::int32_t count, std::int32_t& x, std::int32_t& end) {
  while (x < count && (row[x >> 6] >> (x & 63)) == 0) x = (x | 63) + 1;
  if (x >= count) return false;
  x += __builtin_ctzll(row[x >> 6] >> (x & 63));
  end = x;
  while (end < count) {
    const std::uint64_t gaps = ~row[end >> 6] >> (end & 63);
    if (gaps != 0) {
      end += __builtin_ctzll(gaps);
      break;
    }
    end = (end | 63) + 1;
  }
  return true;
}

/// The rectangles of one layer while its rows are walked.
struct Layer {
  LayerRectangle* rectangles;
  int count;
  int open_count;
};

void close_rectangle(Layer& layer, std::int32_t index, std::int32_t y) {
  layer.rectangles[index].y1 = static_cast<std::int16_t>(y);
}

/// Opens a rectangle at row y; false if the layer is full.
bool open_rectangle(Layer& layer, std::int32_t x0, std::int32_t x1, std::int32_t y) {
  if (is_full(layer.count == kMaxLocalBoxes)) return false;
  layer.rectangles[layer.count++] = {static_cast<std::int16_t>(x0), static_cast<std::int16_t>(x1),
                                     static_cast<std::int16_t>(y), static_cast<std::int16_t>(y), -1};
  return true;
}

/// Takes a row that differs from the row before. Closes the rectangles whose run has gone, and opens one for each new
/// run.
bool take_row(Layer& layer, const std::uint64_t* row, std::int32_t count, std::int32_t y, const std::int32_t* open,
              std::int32_t* still_open) {
  int i = 0;
  int kept = 0;
  std::int32_t end = 0;
  for (std::int32_t x = 0; next_run(row, count, x, end); x = end) {
    while (i < layer.open_count && layer.rectangles[open[i]].x0 < x) close_rectangle(layer, open[i++], y);
    const bool same_start = i < layer.open_count && layer.rectangles[open[i]].x0 == x;
    if (is_full(kept == kMaxRowRuns)) return false;
    if (same_start && layer.rectangles[open[i]].x1 == end) {
      still_open[kept++] = open[i++];
      continue;
    }
    if (same_start) close_rectangle(layer, open[i++], y);
    if (!open_rectangle(layer, x, end, y)) return false;
    still_open[kept++] = layer.count - 1;
  }
  while (i < layer.open_count) close_rectangle(layer, open[i++], y);
  layer.open_count = kept;
  return true;
}

/// Finds the rectangles of one layer. They are sorted by (y0, x0), because they open in that order. Returns their
/// number; -1 if they do not fit.
int layer_rectangles(const Rows& rows, const Window& window, ExtractScratch& scratch, LayerRectangle* rectangles,
                     Work& work) {
  Layer layer{rectangles, 0, 0};
  work.spend(ops::kWord * rows.count * window.words);
  int now = 0;
  for (std::int32_t y = 0; y < rows.count; y = first_difference(rows, window, y + 1)) {
    copy_window(rows.words + static_cast<std::ptrdiff_t>(y) * rows.stride, window, scratch.row);
    const bool fits = take_row(layer, scratch.row, window.words * 64, y, scratch.open[now ^ 1], scratch.open[now]);
    work.spend(ops::kRow + 8 * ops::kTurn * layer.open_count);
    if (!fits) return -1;
    now ^= 1;
  }
  for (int i = 0; i < layer.open_count; ++i) close_rectangle(layer, scratch.open[now ^ 1][i], rows.count);
  return layer.count;
}

bool before(const LayerRectangle& a, const LayerRectangle& b) {
  return a.y0 != b.y0 ? a.y0 < b.y0 : a.x0 < b.x0;
}

bool same_footprint(const LayerRectangle& a, const LayerRectangle& b) {
  return a.x0 == b.x0 && a.x1 == b.x1 && a.y0 == b.y0 && a.y1 == b.y1;
}

/// The rectangle's box, one layer high.
LocalBox box_of(const LayerRectangle& rectangle, const VoxelRange& range, std::int32_t z, double cell) {
  const std::int32_t x = range.lower.x & ~63;
  const std::int32_t y = range.lower.y;
  return {{(x + rectangle.x0) * cell, (y + rectangle.y0) * cell, z * cell},
          {(x + rectangle.x1) * cell, (y + rectangle.y1) * cell, (z + 1) * cell}};
}

/// The boxes found so far. `cell` is the edge of a voxel in metres.
struct Boxes {
  LocalBox* at;
  int count;
  double cell;
};

/// Extends the boxes of a layer's rectangles upwards, to the lower side of layer `end`.
void grow_up(const LayerRectangle* layer, int count, std::int32_t end, const Boxes& boxes) {
  for (int j = 0; j < count; ++j) boxes.at[layer[j].box].upper[2] = end * boxes.cell;
}

/// Matches the rectangles of layer z with those below, both in the same order. A rectangle that equals one below
/// continues its box; any other begins a box. False if the boxes do not fit.
bool join_below(const LayerRectangle* below, int below_count, LayerRectangle* layer, int count, const VoxelRange& range,
                std::int32_t z, Boxes& boxes) {
  int j = 0;
  for (int i = 0; i < count; ++i) {
    while (j < below_count && before(below[j], layer[i])) ++j;
    if (j < below_count && same_footprint(below[j], layer[i])) {
      layer[i].box = below[j].box;
      continue;
    }
    if (is_full(boxes.count == kMaxLocalBoxes)) return false;
    layer[i].box = boxes.count;
    boxes.at[boxes.count++] = box_of(layer[i], range, z, boxes.cell);
  }
  return true;
}

/// Reads the next layer; false if the boxes do not fit. A layer that equals the one below changes nothing.
bool read_layer(const Grid& grid, ExtractScratch& scratch, LocalBox* boxes, Work& work) {
  const VoxelRange& range = scratch.range;
  const Window window = window_of(range);
  const Rows rows = rows_of(grid, range, window, scratch.z);
  const std::ptrdiff_t plane_words = GridAccess::obstacles(grid).index(0, 1);
  work.spend(ops::kPiece + ops::kWord * rows.count * window.words);
  if (scratch.z > range.lower.z && all_equal(rows, window, plane_words, scratch.row)) return true;
  LayerRectangle* const below = scratch.rectangles[scratch.below];
  LayerRectangle* const layer = scratch.rectangles[1 - scratch.below];
  Boxes found{boxes, scratch.count, grid.spec().cell};
  grow_up(below, scratch.below_count, scratch.z, found);
  const int count = layer_rectangles(rows, window, scratch, layer, work);
  work.spend(8 * ops::kTurn * (scratch.below_count + (count < 0 ? kMaxLocalBoxes : count)));
  if (count < 0 || !join_below(below, scratch.below_count, layer, count, range, scratch.z, found)) return false;
  scratch.count = found.count;
  scratch.below = 1 - scratch.below;
  scratch.below_count = count;
  return true;
}

}  // namespace

VoxelRange voxels_within_reach(const Grid& grid, const Box& box) noexcept {
  const GridSpec& spec = grid.spec();
  const double cell = spec.cell;
  const double run_reach = spec.clearance() + cell;
  VoxelRange range;
  range.lower.x = clamp_index((box.lower.x - run_reach) / cell, spec.dims.x);
  range.upper.x = clamp_index((box.upper.x + run_reach) / cell + 1.0, spec.dims.x);
  range.lower.y = clamp_index((box.lower.y - spec.clearance()) / cell + kLatticeTolerance, spec.dims.y);
  range.upper.y = clamp_index((box.upper.y + spec.clearance()) / cell + kFullyInside, spec.dims.y);
  range.lower.z = clamp_index((box.lower.z - spec.clearance()) / cell + kLatticeTolerance, spec.dims.z);
  range.upper.z = clamp_index((box.upper.z + spec.clearance()) / cell + kFullyInside, spec.dims.z);
  return range;
}

void extract_begin(const VoxelRange& range, ExtractScratch& scratch) noexcept {
  const bool empty = range.lower.x >= range.upper.x || range.lower.y >= range.upper.y;
  scratch.range = range;
  scratch.z = empty ? range.upper.z : range.lower.z;
  scratch.count = 0;
  scratch.below = 0;
  scratch.below_count = 0;
}

Progress extract_advance(const Grid& grid, ExtractScratch& scratch, LocalBox* boxes, Work& work) noexcept {
  const VoxelRange& range = scratch.range;
  for (; scratch.z < range.upper.z; ++scratch.z) {
    if (!work.left()) return Progress::kMore;
    if (!read_layer(grid, scratch, boxes, work)) return Progress::kFailed;
  }
  const Boxes found{boxes, scratch.count, grid.spec().cell};
  grow_up(scratch.rectangles[scratch.below], scratch.below_count, range.upper.z, found);
  return Progress::kDone;
}

}  // namespace tern
