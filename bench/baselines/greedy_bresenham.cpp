// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/greedy_bresenham.hpp"

#include <cstdint>
#include <cstdlib>

namespace tern_bench {
namespace {

/// One coordinate of the line: advances where its error term has grown past half a voxel.
struct Stepper {
  std::int32_t at;
  std::int32_t step;
  std::int32_t rise;   ///< distance along this axis
  std::int32_t error;  ///< in voxels times twice the longest distance

  Stepper(std::int32_t from, std::int32_t to)
      : at(from), step(to < from ? -1 : 1), rise(std::abs(to - from)), error(0) {}

  void advance(std::int32_t run) {
    error += 2 * rise;
    if (error <= run) return;
    error -= 2 * run;
    at += step;
  }
};

}  // namespace

bool bresenham_free(const tern::Grid& grid, const tern::Voxel& a, const tern::Voxel& b) {
  Stepper x(a.x, b.x);
  Stepper y(a.y, b.y);
  Stepper z(a.z, b.z);
  const std::int32_t longer = x.rise > y.rise ? x.rise : y.rise;
  const std::int32_t run = longer > z.rise ? longer : z.rise;
  if (!grid.free(a)) return false;
  for (std::int32_t k = 0; k < run; ++k) {
    x.advance(run);
    y.advance(run);
    z.advance(run);
    if (!grid.free({x.at, y.at, z.at})) return false;
  }
  return true;
}

std::vector<tern::Vec3> greedy_bresenham(const tern::Grid& grid, const std::vector<tern::Vec3>& points) {
  std::vector<tern::Vec3> kept{points.front()};
  for (std::size_t at = 0; at + 1 < points.size();) {
    std::size_t next = points.size() - 1;
    while (next > at + 1 && !bresenham_free(grid, grid.voxel_of(points[at]), grid.voxel_of(points[next]))) --next;
    kept.push_back(points[next]);
    at = next;
  }
  return kept;
}

}  // namespace tern_bench
