// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/hull_clear.hpp"

#include <cstdint>

#include "base/math.hpp"
#include "grid/bit_rows.hpp"
#include "tern/halfspace.hpp"

namespace tern {
namespace {

/// How many pairs of points are tried before the search for a plane is given up. A curve that may graze an edge needs
/// the nearest pair, which is computed. Otherwise each pair is made from the one before.
constexpr int kPairs = 4;
constexpr int kGrazingPairs = 2;
/// Dot products of computing the nearest pair.
constexpr Operations kNearestDots = 2 * (kBoxPlanes + 2);
/// Factor that outweighs the rounding of a sum of three squares.
constexpr double kLonger = 1.0 + 1e-15;
/// A little more than the root of three: a box whose sides move in by 1 moves in by that along its diagonal.
constexpr double kRootOfThree = 1.7320509;

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

/// The point of the line from a to b that is nearest to the box. Along the line, the square of the distance is convex,
/// and its slope is linear between the planes of the box's faces.
Vec3 nearest_on_line(const Vec3& a, const Vec3& b, const Box& box) {
  const Vec3 along = b - a;
  const auto slope_at = [&](double t) {
    const Vec3 q = a + t * along;
    return dot(along, q - nearest_in(box, q));
  };
  double begin = 0.0;
  double end = 1.0;
  for (int k = 0; k < kBoxPlanes; ++k) {
    const double face = axis(k % 2 == 0 ? box.lower : box.upper, k / 2);
    const double t = (face - axis(a, k / 2)) / axis(along, k / 2);
    if (t > begin && t < end) (slope_at(t) < 0.0 ? begin : end) = t;
  }
  const double falls = slope_at(begin);
  const double rises = slope_at(end);
  if (!(falls < 0.0)) return a + begin * along;
  if (!(rises > 0.0)) return a + end * along;
  return a + (begin - falls * ((end - begin) / (rises - falls))) * along;
}

/// Distance of two intervals; negative if they overlap.
double gap(double lower, double upper, double other_lower, double other_upper) {
  return larger(other_lower - upper, lower - other_upper);
}

/// The obstacles of a row that count.
struct Row {
  const std::uint64_t* solid;
  const std::uint64_t* pardoned;  ///< null: all of them count
  IndexRange xs;                  ///< voxels that may be pardoned

  std::uint64_t word(std::int32_t k) const {
    return pardoned == nullptr ? solid[k] : solid[k] & ~(pardoned[k] & bits_met(xs, k));
  }
};

Row row_of(const Grid& grid, const Pardon& pardon, std::int32_t y, std::int32_t z) {
  const bool applies = pardon.layer != nullptr && contains(pardon.ys, y) && contains(pardon.zs, z);
  const BitRows rows = GridAccess::obstacles(grid);
  return {rows.row(y, z), applies ? pardon.layer + rows.index(y, z) : nullptr, pardon.xs};
}

/// The first x of the range whose bit is `value`; the range's end if there is none.
std::int32_t find_bit(const Row& row, const IndexRange& range, bool value) {
  if (range.begin >= range.end) return range.end;
  for (std::int32_t k = range.begin >> 6; k <= (range.end - 1) >> 6; ++k) {
    const std::uint64_t word = (value ? row.word(k) : ~row.word(k)) & bits_within(range, k);
    if (word != 0) return kWordBits * k + __builtin_ctzll(word);
  }
  return range.end;
}

/// True if two boxes are at least the distance apart. Rounding can only turn true into false, and shifts the distance
/// by far less than the grant.
bool boxes_apart(const Box& a, const Box& b, double distance) {
  double square = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double apart = gap(axis(a.lower, k), axis(a.upper, k), axis(b.lower, k), axis(b.upper, k));
    if (apart >= distance) return true;
    if (apart > 0.0) square += apart * apart;
  }
  return distance > 0.0 && square >= kLonger * distance * distance;
}

/// The box, smaller by so much on every side that what keeps clear of it is inside the whole box by `depth` at most,
/// along any normal. A side that is too short shrinks to its middle.
Box core_of(const Box& box, double depth) {
  Box core = box;
  for (int a = 0; a < 3; ++a) {
    const double inset = smaller(depth / kRootOfThree, 0.5 * (axis(box.upper, a) - axis(box.lower, a)));
    axis(core.lower, a) += inset;
    axis(core.upper, a) -= inset;
  }
  return core;
}

/// Operations of plane_between() for a hull of so many points, after the first pair.
Operations pairs_operations(double distance, int count) {
  if (distance < 0.0) return ((kGrazingPairs - 1) * count + kNearestDots) * ops::kDot;
  return (kPairs - 1) * count * ops::kDot;
}

/// Looks for a plane that has the box behind it, and all points in front of it by at least the distance. Any point q
/// outside the box gives a plane: it goes through the box's point p that is nearest to q, at right angles to q - p. The
/// best q is the hull's point nearest to the box. It is sought on the line between the curve's ends. If the distance is
/// negative, q may be on the box or inside it, so the box's core takes its place.
bool plane_between(const Vec3* points, int count, const Box& whole, double distance) {
  const bool grazes = distance < 0.0;
  const Box box = grazes ? core_of(whole, -distance) : whole;
  const double wanted = larger(distance, 0.0);
  const int pairs = grazes ? kGrazingPairs : kPairs;
  const Vec3& first = points[0];
  const Vec3& last = points[count - 1];
  Vec3 q = 0.5 * (first + last);
  for (int k = 0; k < pairs; ++k) {
    const Vec3 p = nearest_in(box, q);
    const Vec3 normal = q - p;
    const double size = length(normal);
    if (!(size > 0.0) && !grazes) return false;
    double least = dot(normal, first - p);
    for (int i = 1; i < count; ++i) least = smaller(least, dot(normal, points[i] - p));
    if (size > 0.0 && least >= wanted * size) return true;
    q = grazes ? nearest_on_line(first, last, box) : nearest_on_line(first, last, p);
  }
  return false;
}

/// The hull that rows of obstacles are compared with.
struct Hull {
  const Vec3* points;
  int count;
  Box box;
  Clearance keeps;
  IndexRange alone;  ///< voxels along x that may be near clearance.departed
};

/// The distance that the hull must keep from one box of obstacles.
double distance_from(const Hull& hull, const Box& box) {
  if (hull.keeps.departed == nullptr || !(box.lower.z < hull.keeps.ground)) return hull.keeps.distance;
  const Vec3& place = *hull.keeps.departed;
  return smaller(hull.keeps.distance, length(place - nearest_in(box, place)) - hull.keeps.tolerance);
}

/// The end of the box of obstacles that begins at x. Obstacles that touch along x form one box: its distance is the
/// least of theirs. But near the place Clearance::departed, the hull must keep another distance from each obstacle.
std::int32_t end_of_box(const Row& row, const IndexRange& xs, const IndexRange& alone, std::int32_t x) {
  if (x >= alone.begin && x < alone.end) return x + 1;
  const std::int32_t end = find_bit(row, {x, xs.end}, false);
  return x < alone.begin && alone.begin < end ? alone.begin : end;
}

/// The voxel of a box of obstacles that is nearest to the middle of the hull. The hull may be clear of the others.
std::int32_t nearest_voxel(const Hull& hull, const IndexRange& xs, double cell) {
  const double at = 0.5 * (hull.box.lower.x + hull.box.upper.x) / cell;
  if (!(at > xs.begin)) return xs.begin;
  return at < xs.end ? static_cast<std::int32_t>(at) : xs.end - 1;
}

bool row_clear(const Grid& grid, const Hull& hull, const IndexRange& xs, std::int32_t y, std::int32_t z, Voxel& found,
               Work& work) {
  work.spend(2 * ops::kRow);
  const double cell = grid.spec().cell;
  const Row row = row_of(grid, hull.keeps.pardon, y, z);
  std::int32_t x = find_bit(row, xs, true);
  while (x < xs.end) {
    const std::int32_t end = end_of_box(row, xs, hull.alone, x);
    const Box box{{x * cell, y * cell, z * cell}, {end * cell, (y + 1) * cell, (z + 1) * cell}};
    const double distance = distance_from(hull, box);
    const bool may_touch = hull.keeps.departed != nullptr && !(distance > 0.0);
    bool apart = may_touch || boxes_apart(hull.box, box, distance);
    work.spend(8 * ops::kDot + (apart ? 0 : pairs_operations(distance, hull.count)));
    apart = apart || plane_between(hull.points, hull.count, box, distance);
    if (!apart) {
      found = {nearest_voxel(hull, {x, end}, cell), y, z};
      return false;
    }
    x = find_bit(row, {end, xs.end}, true);
  }
  return true;
}

}  // namespace

IndexRange voxels_within(double lower, double upper, double distance, double cell, std::int32_t count) noexcept {
  const double from = (lower - distance) / cell - 1.0;
  const double to = (upper + distance) / cell + 2.0;
  IndexRange range{0, count};
  // Compared as doubles first: a far coordinate does not fit an integer.
  if (from > 0.0) range.begin = from < count ? static_cast<std::int32_t>(from) : count;
  if (to < count) range.end = to > 0.0 ? static_cast<std::int32_t>(to) : 0;
  return range;
}

double distance_to_cube(const Grid& grid, const Voxel& voxel, const Vec3& point) noexcept {
  const double cell = grid.spec().cell;
  const Box cube{{voxel.x * cell, voxel.y * cell, voxel.z * cell},
                 {(voxel.x + 1) * cell, (voxel.y + 1) * cell, (voxel.z + 1) * cell}};
  return distance(point, nearest_in(cube, point));
}

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

bool hull_clear(const Grid& grid, const Vec3* points, int count, const Clearance& clearance, Voxel& found,
                Work& work) noexcept {
  work.spend(4 * ops::kPiece);
  const GridSpec& spec = grid.spec();
  const double distance = clearance.distance;
  Hull hull{points, count, box_around(points, count), clearance, {0, 0}};
  if (clearance.departed != nullptr) {
    hull.alone = voxels_within(clearance.departed->x, clearance.departed->x, distance, spec.cell, spec.dims.x);
  }
  const Vec3& lower = hull.box.lower;
  const Vec3& upper = hull.box.upper;
  const IndexRange ys = voxels_within(lower.y, upper.y, distance, spec.cell, spec.dims.y);
  const IndexRange zs = voxels_within(lower.z, upper.z, distance, spec.cell, spec.dims.z);
  for (std::int32_t z = zs.begin; z < zs.end; ++z) {
    const double apart_z = larger(0.0, gap(lower.z, upper.z, z * spec.cell, (z + 1) * spec.cell));
    for (std::int32_t y = ys.begin; y < ys.end; ++y) {
      const double apart_y = larger(0.0, gap(lower.y, upper.y, y * spec.cell, (y + 1) * spec.cell));
      const double rest = distance * distance - (apart_y * apart_y + apart_z * apart_z);
      if (rest <= 0.0) continue;
      const IndexRange xs = voxels_within(lower.x, upper.x, square_root(rest), spec.cell, spec.dims.x);
      if (!row_clear(grid, hull, xs, y, z, found, work)) return false;
    }
  }
  return true;
}

}  // namespace tern
