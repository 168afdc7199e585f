// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "check/check_stage.hpp"

namespace tern {
namespace {

/// Rows of voxels that can come within the radius of a polyhedron.
struct Range {
  Voxel lo;
  Voxel hi;  // inclusive
};

/// A box around the polyhedron from those of its planes that are axis-aligned; the grid where there are none.
Box bounding_box(const Grid& grid, const Polyhedron& polyhedron) {
  const GridSpec& spec = grid.spec();
  Box box{{0.0, 0.0, 0.0}, {spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell}};
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    for (int a = 0; a < 3; ++a) {
      if (axis(plane.normal, a) >= 1.0) axis(box.upper, a) = smaller(axis(box.upper, a), plane.offset);
      if (axis(plane.normal, a) <= -1.0) axis(box.lower, a) = larger(axis(box.lower, a), -plane.offset);
    }
  }
  return box;
}

std::int32_t clamp_index(double cells, std::int32_t count) {
  // Compared as doubles first: a far coordinate does not fit an integer.
  if (!(cells > 0.0)) return 0;
  if (cells >= static_cast<double>(count)) return count - 1;
  return static_cast<std::int32_t>(cells);
}

Range voxels_near(const Grid& grid, const Polyhedron& polyhedron) {
  const GridSpec& spec = grid.spec();
  const Box box = bounding_box(grid, polyhedron);
  const double reach = spec.radius + spec.cell;  // a cell more than needed costs little and forgives rounding
  return {{clamp_index((box.lower.x - reach) / spec.cell, spec.dims.x),
           clamp_index((box.lower.y - reach) / spec.cell, spec.dims.y),
           clamp_index((box.lower.z - reach) / spec.cell, spec.dims.z)},
          {clamp_index((box.upper.x + reach) / spec.cell, spec.dims.x),
           clamp_index((box.upper.y + reach) / spec.cell, spec.dims.y),
           clamp_index((box.upper.z + reach) / spec.cell, spec.dims.z)}};
}

/// The least value of normal . p over a box: the corner that the normal points away from.
double support(const Halfspace& plane, const Box& box) {
  const double x = plane.normal.x * (plane.normal.x < 0.0 ? box.upper.x : box.lower.x);
  const double y = plane.normal.y * (plane.normal.y < 0.0 ? box.upper.y : box.lower.y);
  const double z = plane.normal.z * (plane.normal.z < 0.0 ? box.upper.z : box.lower.z);
  return (x + y) + z;
}

bool cuts_off(const Halfspace& plane, const Box& box, double radius) {
  return support(plane, box) >= plane.offset + radius - kCheckDistance;
}

/// Tries the plane that cut off the last box first: neighbours are nearly always cut off by the same one.
bool some_plane_cuts_off(const Polyhedron& polyhedron, const Box& box, double radius, int& last) {
  if (cuts_off(polyhedron.planes[last], box, radius)) return true;
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    if (cuts_off(polyhedron.planes[p], box, radius)) {
      last = p;
      return true;
    }
  }
  return false;
}

/// One past the last voxel of the run of obstacles that begins at x, no further than `end`.
std::int32_t run_end(const std::uint64_t* row, std::int32_t x, std::int32_t end) {
  while (x < end && ((row[x >> 6] >> (x & 63)) & 1u) != 0) ++x;
  return x;
}

bool row_clear(const Grid& grid, const Polyhedron& polyhedron, const Range& range, std::int32_t y, std::int32_t z,
               int& last) {
  const double cell = grid.spec().cell;
  const std::uint64_t* row = grid.obstacle_row(y, z);
  const std::int32_t end = range.hi.x + 1;
  for (std::int32_t x = range.lo.x; x < end;) {
    const std::uint64_t rest = row[x >> 6] >> (x & 63);
    if (rest == 0) {
      x = (x | 63) + 1;
      continue;
    }
    x += __builtin_ctzll(rest);
    if (x >= end) break;
    const std::int32_t stop = run_end(row, x, end);
    const Box box{{x * cell, y * cell, z * cell}, {stop * cell, (y + 1) * cell, (z + 1) * cell}};
    if (!some_plane_cuts_off(polyhedron, box, grid.spec().radius, last)) return false;
    x = stop;
  }
  return true;
}

bool well_formed(const Polyhedron& polyhedron) {
  if (polyhedron.count < 1 || polyhedron.count > kMaxPlanes) return false;
  if (polyhedron.redundant < 0 || polyhedron.redundant > kMaxPlanes - polyhedron.count) return false;
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    if (!finite(plane.normal) || !finite(plane.offset)) return false;
    if (absolute(dot(plane.normal, plane.normal) - 1.0) > 1e-9) return false;
  }
  return true;
}

}  // namespace

bool polyhedron_clear(const Grid& grid, const Polyhedron& polyhedron) noexcept {
  if (!well_formed(polyhedron)) return false;
  const Range range = voxels_near(grid, polyhedron);
  int last = 0;
  for (std::int32_t z = range.lo.z; z <= range.hi.z; ++z) {
    for (std::int32_t y = range.lo.y; y <= range.hi.y; ++y) {
      if (!row_clear(grid, polyhedron, range, y, z, last)) return false;
    }
  }
  return true;
}

}  // namespace tern
