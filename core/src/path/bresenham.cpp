// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/bresenham.hpp"

#include "base/direction.hpp"

namespace tern {
namespace {

/// One coordinate of the line: advances where its error term has grown past half a voxel.
struct Stepper {
  std::int32_t at;
  std::int32_t step;
  std::int32_t rise;   ///< distance along this axis
  std::int32_t error;  ///< in voxels times twice the longest distance

  Stepper(std::int32_t from, std::int32_t to)
      : at(from), step(to < from ? -1 : 1), rise(magnitude(to - from)), error(0) {}

  void advance(std::int32_t run) {
    error += 2 * rise;
    if (error <= run) return;
    error -= 2 * run;
    at += step;
  }
};

}  // namespace

bool bresenham_free(const Grid& grid, const Voxel& a, const Voxel& b) noexcept {
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

}  // namespace tern
