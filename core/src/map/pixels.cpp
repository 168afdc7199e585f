// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pixels of a depth image: each gives a depth up to which its cone is free, and a point that is hit. Single precision
// is enough: the depth is rounded towards the camera, and a hit is off by less than a thousandth of a voxel.
#include "base/math.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// Pixels at a time.
constexpr std::int32_t kChunk = 64;
/// The number of a pixel that is saturated.
constexpr std::uint16_t kSaturated = 65535;

/// How the numbers of an image become depths.
struct Scale {
  float unit, min, max;
  float keep(float z) const { return ((z >= min) & (z < max) & (z > 0.0f)) != 0 ? z : 0.0f; }
};

/// Depths in metres; 0 where a pixel says nothing.
void depths(const DepthView& view, const Scale& scale, std::ptrdiff_t from, std::int32_t count, float* z) {
  if (view.z16 != nullptr) {
    const std::uint16_t* number = view.z16 + from;
    for (std::int32_t k = 0; k < count; ++k) {
      z[k] = number[k] == kSaturated ? 0.0f : scale.keep(static_cast<float>(number[k]) * scale.unit);
    }
  } else {
    const float* number = view.z32 + from;
    for (std::int32_t k = 0; k < count; ++k) z[k] = scale.keep(number[k] * scale.unit);
  }
}

/// The depths that are free for certain, in units: one less than rounding could make of them.
struct FreeDepth {
  float margin, margin_square, range, units;

  Depth of(float z) const {
    float metres = z - (margin + margin_square * z * z);
    metres = metres < range ? metres : range;
    const float whole = metres * units - 1.0f;
    return static_cast<Depth>(static_cast<std::int32_t>(whole > 0.0f ? whole : 0.0f));
  }
};

struct Vec3f {
  float x, y, z;
};
Vec3f to_float(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The points of a row of pixels, in voxels from the window's corner: origin + z * (ray + u * step).
struct RowOfRays {
  Vec3f origin;
  Vec3f ray;
  Vec3f step;
  Vec3f most;  ///< the window's size

  /// -1 below the window, its size beyond.
  static std::int32_t index(float origin, float ray, float z, float most) {
    float at = origin + z * ray;
    at = at > -1.0f ? at : -1.0f;
    at = at < most ? at : most;
    return static_cast<std::int32_t>(at + 1.0f) - 1;
  }
  void points(std::int32_t u, const float* z, std::int32_t count, std::int32_t (*out)[kChunk]) const {
    for (std::int32_t k = 0; k < count; ++k) {
      const float at = static_cast<float>(u + k);
      out[0][k] = index(origin.x, ray.x + at * step.x, z[k], most.x);
      out[1][k] = index(origin.y, ray.y + at * step.y, z[k], most.y);
      out[2][k] = index(origin.z, ray.z + at * step.z, z[k], most.z);
    }
  }
};

/// The rays of row v. The view's steps are the camera's axes, a voxel long.
RowOfRays rays_of(const View& view, const Vec3& origin, const GridSpec& window, std::int32_t v) {
  const double per_cell = 1.0 / window.cell;
  const Vec3 x{view.steps[0].x, view.steps[1].x, view.steps[2].x};
  const Vec3 y{view.steps[0].y, view.steps[1].y, view.steps[2].y};
  const Vec3 ahead{view.steps[0].z, view.steps[1].z, view.steps[2].z};
  const Vec3 ray = (-view.cx / view.fx) * x + ((v - view.cy) / view.fy) * y + ahead;
  // Steps are in metres a voxel: once to have unit axes, once more for voxels instead of metres.
  return {to_float(per_cell * origin),
          to_float((per_cell * per_cell) * ray),
          to_float((per_cell * per_cell / view.fx) * x),
          {static_cast<float>(window.dims.x), static_cast<float>(window.dims.y), static_cast<float>(window.dims.z)}};
}

}  // namespace

void MapState::read_pixels(std::int32_t v) noexcept {
  const DepthView& depth = frame.image;
  const Scale scale{static_cast<float>(depth.scale), static_cast<float>(depth.min), static_cast<float>(depth.max)};
  const float range = static_cast<float>(spec.range);
  const FreeDepth free{static_cast<float>(spec.depth_margin), static_cast<float>(spec.depth_margin_square), range,
                       static_cast<float>(frame.views[0].units)};
  const RowOfRays rays = rays_of(frame.views[0], frame.origin, route.spec(), v);
  Depth* row = frame.views[0].pyramid.row(v);
  for (std::int32_t u = 0; u < depth.width; u += kChunk) {
    const std::int32_t count = depth.width - u < kChunk ? depth.width - u : kChunk;
    float z[kChunk];
    std::int32_t point[3][kChunk];
    depths(depth, scale, static_cast<std::ptrdiff_t>(v) * depth.stride + u, count, z);
    for (std::int32_t k = 0; k < count; ++k) row[u + k] = free.of(z[k]);
    rays.points(u, z, count, point);
    for (std::int32_t k = 0; k < count; ++k) {
      if (z[k] > 0.0f && z[k] <= range) mark_hit({point[0][k], point[1][k], point[2][k]});
    }
  }
}

}  // namespace tern
