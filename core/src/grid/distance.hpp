// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geometry of boxes and of the grid, for the later stages. Computes exact distances of points and segments from boxes,
// and whether points and segments keep their clearance from the obstacle layer. Local frame, metres.
#ifndef TERN_GRID_DISTANCE_HPP
#define TERN_GRID_DISTANCE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// A distance that falls short of a radius by at most this many metres counts as equal to it. If voxels are larger than
/// a metre, this is a share of a voxel instead.
constexpr double kClearTolerance = 1e-9;

/// Metres by which a point of this grid may be nearer than the radius, or beyond the boundary. The sum of
/// kClearTolerance and two rounding errors. The first is kWorldUlps units in the last place of a world coordinate, from
/// which the origin is subtracted. The second is kLocalUlps units of a local coordinate, for the products and sums of a
/// distance.
double contact_tolerance(const GridSpec& spec) noexcept;

/// Below this distance, in metres, the direction between the closest points of two solids is only rounding error. Above
/// it, the unit vector of that direction is accurate to 1e-8. Voxels larger than a metre have coordinates with larger
/// rounding errors, so their tolerance is larger.
double direction_tolerance(const GridSpec& spec) noexcept;
constexpr double kMetricDirection = 1e-7;
constexpr double kWorldUlps = 2.0;
constexpr double kLocalUlps = 4.0;

/// The point of a closed box nearest to p; p itself if it is inside.
Vec3 nearest_in_box(const Vec3& p, const Box& box) noexcept;

/// The nearest points of a segment and a box. Of several pairs that are equally near, the one nearest to the segment's
/// beginning.
struct ClosestPair {
  Vec3 on_segment;
  Vec3 on_box;
  double distance_squared;
  double t;  ///< on_segment = a + t (b - a), 0 <= t <= 1
};

/// The closest pair of the segment from a to b (equal ends are a point) and the closed box. Exact but for rounding. The
/// squared distance is convex in t. It is quadratic between the values of t, at most six, at which the segment crosses
/// a face's plane. So at most seven pieces are minimised in closed form.
ClosestPair segment_box_closest(const Vec3& a, const Vec3& b, const Box& box) noexcept;

/// The distance_squared of segment_box_closest().
double segment_box_distance_squared(const Vec3& a, const Vec3& b, const Box& box) noexcept;

/// True if the radius is >= 0 (not NaN), the point lies inside the grid's boundary, and every obstacle cube is at least
/// `radius` away; both to within contact_tolerance(). With radius 0, the point may touch the surface of obstacles but
/// not enter them. Cubes that share a face leave no gap, nor do cubes on all sides of an edge or a corner. Reads only
/// the voxels within the radius, and one more on each side.
bool point_clear(const Grid& grid, const Vec3& local, double radius) noexcept;

/// True if point_clear() holds for every point of the segment from a to b. Reads only the voxels within the radius of
/// its bounding box, and one more on each side.
bool segment_clear(const Grid& grid, const Vec3& a, const Vec3& b, double radius) noexcept;
/// Operations of segment_clear() from a to a + way; of point_clear() if `way` is zero.
Operations clear_operations(const GridSpec& spec, const Vec3& way, double radius) noexcept;

/// The state of a search for the free voxel nearest to a point. Plain data; needs no initialisation before
/// nearest_begin.
struct NearestFree {
  Vec3 point;  ///< in cells
  bool found;
  double distance_squared;  ///< squared distance of the best voxel so far, in cells
  Voxel voxel;
  std::int32_t square;  ///< the next rows to read are at this distance, in rows, from the point's row
  std::int32_t last;
};

/// Finds the free voxel (up-to-date blocked layer) whose centre is nearest to the point, which may lie anywhere; ties
/// go to the least z, then y, then x. A piece of work reads the rows at one distance from the point's row, each word of
/// the layer at most once. kDone: `found` says whether any voxel is free, and `voxel` is the nearest.
void nearest_begin(NearestFree& nearest, const Grid& grid, const Vec3& local) noexcept;
Progress nearest_advance(NearestFree& nearest, const Grid& grid, Work& work) noexcept;

}  // namespace tern

#endif
