// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/sight.hpp"

#include "base/math.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// The part of the segment whose parameter lies in [begin, end]; empty where begin > end.
struct Span {
  double begin;
  double end;
};

/// One coordinate of the segment over its parameter t in [0, 1], in voxels.
struct Track {
  double from;
  double slope;
  double reach;  ///< how far from the segment voxels count as met

  /// Voxels that the track comes within reach of while t runs over the span; half-open.
  IndexRange voxels(const Span& span) const {
    const double a = from + slope * span.begin;
    const double b = from + slope * span.end;
    // One beyond the largest grid on either side: outside is outside.
    return {ceil_index(smaller(a, b) - reach - 1.0, -2, kMaxDimension + 1),
            floor_index(larger(a, b) + reach, -2, kMaxDimension + 1) + 1};
  }

  /// The part of `span` during which the track is within reach of voxel `index`.
  Span within(std::int32_t index, const Span& span) const {
    // A track that moves less than its rounding allowance is near the voxel all the time or never.
    if (absolute(slope) <= kSightRounding) return span;
    const double t0 = (index - reach - from) / slope;
    const double t1 = (index + 1.0 + reach - from) / slope;
    return {larger(span.begin, smaller(t0, t1)), smaller(span.end, larger(t0, t1))};
  }
};

/// True where voxels [begin, end) of a row of the blocked layer are all free; the range lies in the row.
bool row_free(const std::uint64_t* row, const IndexRange& range) {
  const std::int32_t first = range.begin >> 6;
  const std::int32_t last = (range.end - 1) >> 6;
  for (std::int32_t k = first; k <= last; ++k) {
    std::uint64_t word = row[k];
    if (k == first) word &= ~std::uint64_t{0} << (range.begin & 63);
    if (k == last) word &= ~std::uint64_t{0} >> (63 - ((range.end - 1) & 63));
    if (word != 0) return false;
  }
  return true;
}

bool in_range(const IndexRange& range, std::int32_t count) {
  return range.begin >= 0 && range.end <= count;
}

}  // namespace

bool line_of_sight(const Grid& grid, const Vec3& a, const Vec3& b, double margin) noexcept {
  const double scale = grid.spec().cell;
  const Voxel& dims = grid.spec().dims;
  const double reach = margin + kSightRounding;
  const Track x{a.x / scale, (b.x - a.x) / scale, reach};
  const Track y{a.y / scale, (b.y - a.y) / scale, reach};
  const Track z{a.z / scale, (b.z - a.z) / scale, reach};
  const Span whole{0.0, 1.0};
  const IndexRange layers = z.voxels(whole);
  if (!in_range(layers, dims.z)) return false;
  for (std::int32_t k = layers.begin; k < layers.end; ++k) {
    const Span in_layer = z.within(k, whole);
    if (in_layer.begin > in_layer.end) continue;
    const IndexRange rows = y.voxels(in_layer);
    if (!in_range(rows, dims.y)) return false;
    for (std::int32_t j = rows.begin; j < rows.end; ++j) {
      const Span in_row = y.within(j, in_layer);
      if (in_row.begin > in_row.end) continue;
      const IndexRange cells = x.voxels(in_row);
      if (!in_range(cells, dims.x) || !row_free(grid.blocked_row(j, k), cells)) return false;
    }
  }
  return true;
}

}  // namespace tern
