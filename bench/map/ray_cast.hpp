// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a map by ray casting calls free: every voxel that some pixel's ray passes through before its depth.
#ifndef TERN_BENCH_MAP_RAY_CAST_HPP
#define TERN_BENCH_MAP_RAY_CAST_HPP

#include <cmath>
#include <vector>

#include "tern/map.hpp"

namespace tern_bench {

class RayCast {
 public:
  explicit RayCast(const tern::MapSpec& spec)
      : spec_(spec),
        free_(static_cast<std::size_t>(spec.dims.x) * static_cast<std::size_t>(spec.dims.y) *
              static_cast<std::size_t>(spec.dims.z)) {}

  /// Passes from the eye along the ray, up to `end` lengths of it, and not into the voxel there.
  void pass(const tern::Vec3& eye, const tern::Vec3& ray, double end) {
    const double origin[] = {spec_.origin.x, spec_.origin.y, spec_.origin.z};
    const double from[] = {eye.x, eye.y, eye.z}, along[] = {ray.x, ray.y, ray.z};
    int voxel[3], step[3], last[3];
    double next[3], delta[3];
    for (int a = 0; a < 3; ++a) {
      const double cells = (from[a] - origin[a]) / spec_.cell, speed = along[a] / spec_.cell;
      voxel[a] = static_cast<int>(std::floor(cells));
      last[a] = static_cast<int>(std::floor(cells + end * speed));
      step[a] = speed < 0.0 ? -1 : 1;
      delta[a] = speed == 0.0 ? 1e30 : std::abs(1.0 / speed);
      next[a] = speed == 0.0 ? 1e30 : (step[a] > 0 ? voxel[a] + 1 - cells : cells - voxel[a]) * delta[a];
    }
    while (inside(voxel) && !(voxel[0] == last[0] && voxel[1] == last[1] && voxel[2] == last[2])) {
      free_[at(voxel)] = true;
      const int a = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
      if (next[a] > end) return;
      voxel[a] += step[a];
      next[a] += delta[a];
    }
  }

  bool free(const tern::Voxel& v) const {
    const int voxel[] = {v.x, v.y, v.z};
    return free_[at(voxel)];
  }

 private:
  bool inside(const int (&v)[3]) const {
    return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < spec_.dims.x && v[1] < spec_.dims.y && v[2] < spec_.dims.z;
  }
  std::size_t at(const int (&v)[3]) const {
    return (static_cast<std::size_t>(v[2]) * static_cast<std::size_t>(spec_.dims.y) + static_cast<std::size_t>(v[1])) *
               static_cast<std::size_t>(spec_.dims.x) +
           static_cast<std::size_t>(v[0]);
  }

  tern::MapSpec spec_;
  std::vector<bool> free_;
};

}  // namespace tern_bench

#endif
