// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random poses and images for a rolling map, and a hash of what it holds. Without a heap: firmware runs it, too.
#ifndef TERN_TESTS_SUPPORT_MAP_NOISE_HPP
#define TERN_TESTS_SUPPORT_MAP_NOISE_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "support/random.hpp"
#include "tern/map.hpp"

namespace tern_test {

/// Does the job in work; the slices do not matter.
inline tern::Status finish(tern::RollingMap& map, std::uint32_t slice = 1u << 30) {
  tern::Status status = tern::Status::kRunning;
  while (status == tern::Status::kRunning) status = map.step(slice);
  return status;
}

/// A uniformly random rotation.
inline void random_quaternion(Random& random, double (&q)[4]) {
  double square = 0.0;
  do {
    square = 0.0;
    for (double& part : q) {
      part = random.real(-1.0, 1.0);
      square += part * part;
    }
  } while (square > 1.0 || square < 0.01);
  for (double& part : q) part /= std::sqrt(square);
}

/// An image of smooth patches, edges, single near pixels and pixels that say nothing.
inline void fill_randomly(Random& random, float* image, int w, int h, double range) {
  const auto at = [&](int u, int v) -> float& { return image[v * w + u]; };
  const double base = random.real(0.3, 1.4) * range;
  const double slope_u = random.real(-0.5, 0.5) * range / w;
  const double slope_v = random.real(-0.5, 0.5) * range / h;
  for (int v = 0; v < h; ++v) {
    for (int u = 0; u < w; ++u) at(u, v) = static_cast<float>(base + slope_u * u + slope_v * v);
  }
  for (int k = random.integer(0, 4); k > 0; --k) {  // things in front
    const int u0 = random.integer(0, w - 1), v0 = random.integer(0, h - 1);
    const int u1 = std::min(w - 1, u0 + random.integer(0, w / 3)), v1 = std::min(h - 1, v0 + random.integer(0, h / 3));
    const float depth = static_cast<float>(random.real(0.05, 1.0) * range);
    for (int v = v0; v <= v1; ++v) {
      for (int u = u0; u <= u1; ++u) at(u, v) = depth;
    }
  }
  const double outliers = random.chance(0.5) ? 0.0 : 0.01;
  for (int k = 0; k < w * h; ++k) {
    if (!random.chance(outliers)) continue;
    const float odd[] = {0.0f, NAN, INFINITY, -1.0f, 0.01f, 1e9f, static_cast<float>(random.real(0.2, range))};
    image[k] = odd[random.integer(0, 6)];
  }
}

/// One hash over all that a map holds, voxel by voxel.
inline std::uint64_t hash_of(const tern::RollingMap& map) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  const tern::Voxel dims = map.route().spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        const tern::Voxel v{x, y, z};
        const unsigned bits = (map.seen(v) ? 1u : 0u) | (map.route().obstacle(v) ? 2u : 0u) |
                              (map.safe().obstacle(v) ? 4u : 0u) | (map.route().free(v) ? 8u : 0u) |
                              (map.safe().free(v) ? 16u : 0u);
        hash = (hash ^ bits) * 0x100000001B3u;
      }
    }
  }
  return hash;
}

}  // namespace tern_test

#endif
