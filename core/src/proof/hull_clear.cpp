// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "proof/hull_clear.hpp"

#include <cstdint>

#include "base/math.hpp"
#include "grid/bit_rows.hpp"

namespace tern {
namespace {

/// Times that the pair of nearest points is improved before a hull is given up.
constexpr int kImprovements = 4;

Vec3 nearest_in(const Box& box, const Vec3& p) {
  return {clamp(p.x, box.lower.x, box.upper.x), clamp(p.y, box.lower.y, box.upper.y),
          clamp(p.z, box.lower.z, box.upper.z)};
}

/// The point of the line from a to b that is nearest to p.
Vec3 nearest_on_line(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 along = b - a;
  const double square = dot(along, along);
  if (!(square > 0.0)) return a;
  return a + clamp(dot(along, p - a) / square, 0.0, 1.0) * along;
}

/// Distance of two intervals; negative where they overlap.
double gap(double lower, double upper, double other_lower, double other_upper) {
  return larger(other_lower - upper, lower - other_upper);
}

/// Voxels of an axis that come within the distance of [lower, upper], one more to either side for rounding.
IndexRange voxels_within(double lower, double upper, double distance, double cell, std::int32_t count) {
  const double from = (lower - distance) / cell - 1.0;
  const double to = (upper + distance) / cell + 2.0;
  IndexRange range{0, count};
  // Compared as doubles first: a far coordinate does not fit an integer.
  if (from > 0.0) range.begin = from < count ? static_cast<std::int32_t>(from) : count;
  if (to < count) range.end = to > 0.0 ? static_cast<std::int32_t>(to) : 0;
  return range;
}

/// The first x of the range whose bit is `value`; the range's end where none is.
std::int32_t find_bit(const std::uint64_t* row, const IndexRange& range, bool value) {
  if (range.begin >= range.end) return range.end;
  for (std::int32_t k = range.begin >> 6; k <= (range.end - 1) >> 6; ++k) {
    const std::uint64_t word = (value ? row[k] : ~row[k]) & bits_within(range, k);
    if (word != 0) return kWordBits * k + __builtin_ctzll(word);
  }
  return range.end;
}

/// What a row is held against.
struct Hull {
  const Vec3* points;
  int count;
  Box box;
  double distance;
};

/// Obstacles that touch along x are one box: its distance is the least of theirs.
bool row_clear(const Grid& grid, const Hull& hull, const IndexRange& xs, std::int32_t y, std::int32_t z, Voxel& found) {
  const double cell = grid.spec().cell;
  const std::uint64_t* const row = grid.obstacle_row(y, z);
  std::int32_t x = find_bit(row, xs, true);
  while (x < xs.end) {
    const std::int32_t end = find_bit(row, {x, xs.end}, false);
    const Box box{{x * cell, y * cell, z * cell}, {end * cell, (y + 1) * cell, (z + 1) * cell}};
    if (!hull_apart(hull.points, hull.count, box, hull.distance)) {
      found = {x, y, z};
      return false;
    }
    x = find_bit(row, {end, xs.end}, true);
  }
  return true;
}

}  // namespace

Box box_around(const Vec3* points, int count) noexcept {
  Box box{points[0], points[0]};
  for (int i = 1; i < count; ++i) {
    for (int a = 0; a < 3; ++a) {
      axis(box.lower, a) = smaller(axis(box.lower, a), axis(points[i], a));
      axis(box.upper, a) = larger(axis(box.upper, a), axis(points[i], a));
    }
  }
  return box;
}

/// Any point q outside the box gives a plane: through the box's point p that is nearest to q, at right angles to q - p.
/// The box lies behind it. So the hull keeps the distance if all points lie so far in front of it. The best q is the
/// hull's point nearest to the box; it is looked for on the line between the curve's ends.
bool hull_apart(const Vec3* points, int count, const Box& box, double distance) noexcept {
  const Box around = box_around(points, count);
  for (int a = 0; a < 3; ++a) {
    const double apart = gap(axis(around.lower, a), axis(around.upper, a), axis(box.lower, a), axis(box.upper, a));
    if (apart >= distance) return true;
  }
  Vec3 q = 0.5 * (points[0] + points[count - 1]);
  for (int k = 0; k < kImprovements; ++k) {
    const Vec3 p = nearest_in(box, q);
    const Vec3 normal = q - p;
    const double size = length(normal);
    if (!(size > 0.0)) return false;
    double least = dot(normal, points[0] - p);
    for (int i = 1; i < count; ++i) least = smaller(least, dot(normal, points[i] - p));
    if (least >= distance * size) return true;
    q = nearest_on_line(points[0], points[count - 1], p);
  }
  return false;
}

bool hull_clear(const Grid& grid, const Vec3* points, int count, double distance, Voxel& found) noexcept {
  const GridSpec& spec = grid.spec();
  const Hull hull{points, count, box_around(points, count), distance};
  const Vec3& lower = hull.box.lower;
  const Vec3& upper = hull.box.upper;
  const IndexRange xs = voxels_within(lower.x, upper.x, distance, spec.cell, spec.dims.x);
  const IndexRange ys = voxels_within(lower.y, upper.y, distance, spec.cell, spec.dims.y);
  const IndexRange zs = voxels_within(lower.z, upper.z, distance, spec.cell, spec.dims.z);
  for (std::int32_t z = zs.begin; z < zs.end; ++z) {
    const double apart_z = larger(0.0, gap(lower.z, upper.z, z * spec.cell, (z + 1) * spec.cell));
    for (std::int32_t y = ys.begin; y < ys.end; ++y) {
      const double apart_y = larger(0.0, gap(lower.y, upper.y, y * spec.cell, (y + 1) * spec.cell));
      if (apart_y * apart_y + apart_z * apart_z >= distance * distance) continue;
      if (!row_clear(grid, hull, xs, y, z, found)) return false;
    }
  }
  return true;
}

}  // namespace tern
