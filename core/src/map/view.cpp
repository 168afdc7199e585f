// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/view.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// Pixels by which rounding may misplace an edge; far more than it does.
constexpr double kPixelRounding = 1e-6;
/// Nearest depth that is projected, as a part of a voxel.
constexpr double kNearest = 1e-3;

/// The image of an interval of x, from depth `near` to `far`, in pixels.
struct Interval {
  double from;
  double to;
};
Interval project(double x, double half, double one_by_near, double one_by_far, double focal, double center) {
  const double lower = x - half;
  const double upper = x + half;
  const double from = focal * (lower * (lower < 0.0 ? one_by_near : one_by_far)) + center;
  const double to = focal * (upper * (upper < 0.0 ? one_by_far : one_by_near)) + center;
  return {from + (0.5 - kPixelRounding), to + (0.5 + kPixelRounding)};
}

bool misses(const Interval& i, std::int32_t count) {
  return i.to < 0.0 || i.from >= count;
}
bool within(const Interval& i, std::int32_t count) {
  return i.from >= 0.0 && i.to < count;
}

Vec3 magnitudes(const Vec3& v) {
  return {absolute(v.x), absolute(v.y), absolute(v.z)};
}

void widen(IndexRange& range, double cells, std::int32_t count) {
  const std::int32_t begin = floor_index(cells - 1.0, 0, count);
  const std::int32_t end = ceil_index(cells + 1.0, 0, count);
  if (begin < range.begin) range.begin = begin;
  if (end > range.end) range.end = end;
}

}  // namespace

Vec3 View::center(const Voxel& lowest, double size) const noexcept {
  const double h = 0.5 * size;
  return corner + ((lowest.x + h) * steps[0] + (lowest.y + h) * steps[1] + (lowest.z + h) * steps[2]);
}

Sight View::look(const Voxel& lowest, std::int32_t size) const noexcept {
  const Vec3 c = center(lowest, size);
  const double deepest = c.z + size * half.z;
  if (!(deepest > 0.0)) return Sight::kNone;
  const double grown = growth + growth_ahead * deepest;
  const double far = deepest + grown;
  const double near = c.z - size * half.z - grown;
  if (near * units > kDepthUnits) return Sight::kNone;
  if (near < kNearest * half.z) return Sight::kPart;
  const double one_by_near = 1.0 / near;
  const double one_by_far = 1.0 / far;
  const Interval u = project(c.x, size * half.x + grown, one_by_near, one_by_far, fx, cx);
  const Interval v = project(c.y, size * half.y + grown, one_by_near, one_by_far, fy, cy);
  if (misses(u, width) || misses(v, height)) return Sight::kNone;
  if (!within(u, width) || !within(v, height)) return Sight::kPart;
  const PixelBox box{static_cast<std::int32_t>(u.from), static_cast<std::int32_t>(u.to),
                     static_cast<std::int32_t>(v.from), static_cast<std::int32_t>(v.to)};
  const std::int32_t level = pyramid.level_for(box);
  if (level >= pyramid.levels()) return Sight::kPart;
  if (pyramid.least(box, level) >= far * units) return Sight::kAll;
  return size > 1 && pyramid.most(box, level) < near * units ? Sight::kNone : Sight::kPart;
}

void place(View& view, const Vec3 (&axes)[3], const Vec3& local_center, double cell) noexcept {
  view.corner = -1.0 * Vec3{dot(axes[0], local_center), dot(axes[1], local_center), dot(axes[2], local_center)};
  for (int a = 0; a < 3; ++a) view.steps[a] = cell * Vec3{axis(axes[0], a), axis(axes[1], a), axis(axes[2], a)};
  view.half = 0.5 * (magnitudes(view.steps[0]) + magnitudes(view.steps[1]) + magnitudes(view.steps[2]));
}

VoxelBox reach(const View& view, double range, const GridSpec& window) noexcept {
  VoxelBox box{{window.dims.x, 0}, {window.dims.y, 0}, {window.dims.z, 0}};
  // The camera's axes in cells: the steps are orthogonal and one cell long.
  const double scale = 1.0 / (window.cell * window.cell);
  for (int corner = 0; corner < 5; ++corner) {
    const double u = ((corner & 1) != 0 ? view.width - 0.5 : -0.5) - view.cx;
    const double v = ((corner & 2) != 0 ? view.height - 0.5 : -0.5) - view.cy;
    const Vec3 ray = corner < 4 ? range * Vec3{u / view.fx, v / view.fy, 1.0} : kZero;
    const Vec3 from_corner = ray - view.corner;
    widen(box.x, scale * dot(view.steps[0], from_corner), window.dims.x);
    widen(box.y, scale * dot(view.steps[1], from_corner), window.dims.y);
    widen(box.z, scale * dot(view.steps[2], from_corner), window.dims.z);
  }
  return box;
}

}  // namespace tern
