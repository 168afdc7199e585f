// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/sight.hpp"

#include "base/math.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// The part of the segment whose parameter lies in [begin, end]; empty if begin > end.
struct Span {
  double begin;
  double end;
};

/// One coordinate of the segment, in voxels, as a function of its parameter t in [0, 1]. Also holds precomputed values
/// that each voxel on the way needs.
struct Track {
  double from;
  double slope;
  double reach;    ///< voxels up to this far from the segment count as met
  double inverse;  ///< 1 / slope; 0 if the track moves less than its rounding allowance
  double enter;    ///< the track comes within reach of voxel i at t = (i - enter) * inverse
  double leave;    ///< the track leaves the reach of voxel i at t = (i - leave) * inverse

  Track(double a, double b, double margin) : from(a), slope(b - a), reach(margin) {
    const double before = from + reach;
    const double behind = from - reach - 1.0;
    const bool forward = slope > 0.0;
    inverse = absolute(slope) <= kSightRounding ? 0.0 : 1.0 / slope;
    enter = forward ? before : behind;
    leave = forward ? behind : before;
  }

  /// The range of voxels (half-open) that come within reach while t runs over the span. Only for tracks that are
  /// inside().
  IndexRange voxels(const Span& span) const {
    const double a = from + slope * span.begin;
    const double b = from + slope * span.end;
    // Truncation towards zero is right here: the track is inside the grid, so -1 < low and 0 < high.
    const double low = smaller(a, b) - reach - 1.0;
    const std::int32_t first = static_cast<std::int32_t>(low);
    return {first + (first < low ? 1 : 0), static_cast<std::int32_t>(larger(a, b) + reach) + 1};
  }

  /// The part of `span` in which the track is within reach of voxel `index`.
  Span within(std::int32_t index, const Span& span) const {
    // A track that hardly moves is within reach of the voxel either all the time or never.
    if (absolute(slope) <= kSightRounding) return span;
    return {larger(span.begin, (index - enter) * inverse), smaller(span.end, (index - leave) * inverse)};
  }

  /// The voxel of the point at t. Only for tracks that are inside(): they are positive.
  std::int32_t voxel(double t) const { return static_cast<std::int32_t>(from + slope * t); }

  /// True if every voxel that comes within reach is one of the `count` voxels of the axis. False for NaN.
  bool inside(std::int32_t count) const {
    const double to = from + slope;
    return smaller(from, to) - reach > 0.0 && larger(from, to) + reach < count;
  }
};

/// Voxel number n of a range, in the order in which the track meets them. A line is usually blocked near the end that
/// tightening has moved, and that end comes first.
std::int32_t met(const Track& track, const IndexRange& range, std::int32_t n) {
  return track.slope < 0.0 ? range.end - 1 - n : range.begin + n;
}

/// True if voxels [begin, end) of a row of the blocked layer are all free. The range must lie in the row.
bool row_free(const std::uint64_t* row, const IndexRange& range) {
  const std::int32_t first = range.begin >> 6;
  const std::int32_t last = (range.end - 1) >> 6;
  // Most ranges are a few voxels in one word.
  if (first == last) return (row[first] >> (range.begin & 63)) << (kWordBits - (range.end - range.begin)) == 0;
  for (std::int32_t k = first; k <= last; ++k) {
    if ((row[k] & bits_within(range, k)) != 0) return false;
  }
  return true;
}

/// True if all voxels that the thick segment meets in one layer are free.
bool layer_free(const Grid& grid, const Track& x, const Track& y, std::int32_t layer, const Span& in_layer) {
  const IndexRange rows = y.voxels(in_layer);
  for (std::int32_t n = 0; n < rows.end - rows.begin; ++n) {
    const std::int32_t row = met(y, rows, n);
    const Span in_row = y.within(row, in_layer);
    if (in_row.begin > in_row.end) continue;
    if (!row_free(grid.blocked_row(row, layer), x.voxels(in_row))) return false;
  }
  return true;
}

/// The t at which a segment is probed before its voxels are walked: its middle first, then the middles of the remaining
/// parts.
constexpr double kProbes[] = {0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875};

/// True if the segment is in a blocked voxel at one of the probes. Most lines that are not in sight run into something
/// wide, and a few probes find that sooner than the walk.
bool probes_blocked(const Grid& grid, const Track& x, const Track& y, const Track& z) {
  for (const double t : kProbes) {
    const std::int32_t at = x.voxel(t);
    const std::uint64_t word = grid.blocked_row(y.voxel(t), z.voxel(t))[at >> 6];
    if (((word >> (at & 63)) & 1u) != 0) return true;
  }
  return false;
}

/// The line of sight without regard to thin axes: all voxels near the segment must be free.
bool whole_line_of_sight(const Grid& grid, const Vec3& a, const Vec3& b, double margin) {
  const double scale = 1.0 / grid.spec().cell;
  const Voxel& dims = grid.spec().dims;
  const double reach = margin + kSightRounding;
  const Track x(a.x * scale, b.x * scale, reach);
  const Track y(a.y * scale, b.y * scale, reach);
  const Track z(a.z * scale, b.z * scale, reach);
  if (!x.inside(dims.x) || !y.inside(dims.y) || !z.inside(dims.z)) return false;
  if (probes_blocked(grid, x, y, z)) return false;
  const Span whole{0.0, 1.0};
  const IndexRange layers = z.voxels(whole);
  for (std::int32_t n = 0; n < layers.end - layers.begin; ++n) {
    const std::int32_t layer = met(z, layers, n);
    const Span in_layer = z.within(layer, whole);
    if (in_layer.begin <= in_layer.end && !layer_free(grid, x, y, layer, in_layer)) return false;
  }
  return true;
}

/// Layers that a segment may lie in on each thin axis; without meaning on other axes.
struct Layers {
  IndexRange open[3];
  bool thin[3];
};

/// The segment moved to the middle of one layer on each thin axis, and whether its ends lie in these layers.
struct Flattened {
  Vec3 a;
  Vec3 b;
  bool holds;
};

/// Flattens the segment. Bit a of `choice` is set for the second open layer of axis a.
Flattened flattened(const Grid& grid, const Layers& layers, int choice, const Vec3& a, const Vec3& b) {
  const double cell = grid.spec().cell;
  Flattened flat{a, b, true};
  for (int k = 0; k < 3; ++k) {
    if (!layers.thin[k]) continue;
    const double lower = layers.open[k].begin + (choice >> k & 1);
    Vec3* const ends[] = {&flat.a, &flat.b};
    for (Vec3* end : ends) {
      const double at = axis(*end, k) / cell - lower;
      flat.holds = flat.holds && at >= -kLatticeTolerance && at <= 1.0 + kLatticeTolerance;
      axis(*end, k) = (lower + 0.5) * cell;
    }
  }
  return flat;
}

/// The line of sight inside a thin boundary. The margin has no meaning on a thin axis. The voxels of one layer suffice
/// if they are free and the layer holds the whole segment; otherwise, the voxels of all open layers must be free.
bool thin_line_of_sight(const Grid& grid, const Layers& layers, const Vec3& a, const Vec3& b, double margin) {
  bool all = true;
  for (int choice = 0; choice < 8; ++choice) {
    bool exists = true;
    for (int k = 0; k < 3; ++k) {
      const int second = choice >> k & 1;
      exists = exists && (second == 0 || (layers.thin[k] && layers.open[k].end - layers.open[k].begin == 2));
    }
    if (!exists) continue;
    const Flattened flat = flattened(grid, layers, choice, a, b);
    const bool seen = whole_line_of_sight(grid, flat.a, flat.b, margin);
    if (seen && flat.holds) return true;
    all = all && seen;
  }
  return all;
}

}  // namespace

bool line_of_sight(const Grid& grid, const Vec3& a, const Vec3& b, double margin) noexcept {
  Layers layers{};
  bool any = false;
  for (int k = 0; k < 3; ++k) {
    layers.thin[k] = is_thin(grid, k);
    if (layers.thin[k]) layers.open[k] = inside_boundary(grid, k);
    any = any || layers.thin[k];
  }
  return any ? thin_line_of_sight(grid, layers, a, b, margin) : whole_line_of_sight(grid, a, b, margin);
}

}  // namespace tern
