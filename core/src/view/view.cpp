// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "view/view.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

void widen(IndexRange& range, double cells, std::int32_t count) {
  const std::int32_t begin = floor_index(cells - 1.0, 0, count);
  const std::int32_t end = ceil_index(cells + 1.0, 0, count);
  if (begin < range.begin) range.begin = begin;
  if (end > range.end) range.end = end;
}

}  // namespace

Vec3 View::at(double x, double y, double z) const noexcept {
  return corner + (x * steps[0] + y * steps[1] + z * steps[2]);
}

void place(View& view, const Vec3 (&axes)[3], const Vec3& local_center, double cell) noexcept {
  view.corner = -1.0 * Vec3{dot(axes[0], local_center), dot(axes[1], local_center), dot(axes[2], local_center)};
  for (int a = 0; a < 3; ++a) view.steps[a] = cell * Vec3{axis(axes[0], a), axis(axes[1], a), axis(axes[2], a)};
}

VoxelBox reach(const View& view, double range, const GridSpec& window) noexcept {
  VoxelBox box{{window.dims.x, 0}, {window.dims.y, 0}, {window.dims.z, 0}};
  // The camera's axes in cells. The steps are orthogonal and one cell long.
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
