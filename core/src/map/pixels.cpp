// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pixels of a depth image. Each gives a depth up to which its cone is free, and a voxel that is hit. Single precision
// is enough: the depth is rounded towards the camera, and a hit is off by less than a thousandth of a voxel.
#include "base/math.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// Pixels that are processed together.
constexpr std::int32_t kChunk = 64;
/// Depths of a chunk, and the voxels that they hit.
struct Chunk {
  Four fours[kChunk / 4];
  float* numbers() { return reinterpret_cast<float*>(fours); }
};
struct ChunkOfVoxels {
  FourInts fours[3][kChunk / 4];
  const std::int32_t* axis(int a) const { return reinterpret_cast<const std::int32_t*>(fours[a]); }
};

/// The number of a saturated pixel.
constexpr float kSaturated = 65535.0f;

/// Converts the numbers of an image to depths in metres. A pixel without a measurement becomes 0. The comparisons are
/// separate selections, which the compiler can vectorise.
struct Scale {
  float unit, min, max;

  float depth(float number) const {
    const float z = number * unit;
    const float far_enough = z >= min ? z : 0.0f;
    const float kept = z < max ? far_enough : 0.0f;
    return kept > 0.0f ? kept : 0.0f;
  }
};

template <typename Number>
void depths(const Number* numbers, const Scale& scale, std::int32_t count, float* z) {
  for (std::int32_t k = 0; k < count; ++k) z[k] = scale.depth(static_cast<float>(numbers[k]));
}

Scale scale_of(const DepthView& view) {
  const float unit = static_cast<float>(view.scale);
  const float max = static_cast<float>(view.max);
  const float saturated = kSaturated * unit;
  return {unit, static_cast<float>(view.min), view.z16 != nullptr && saturated < max ? saturated : max};
}

/// Converts a measured depth to the depth that is certainly free, in units. The unit that it subtracts covers rounding.
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

/// Computes the points that a row of pixels hits, in voxels from the window's corner: origin + z * (ray + u * step).
struct RowOfRays {
  Vec3f origin;
  Vec3f ray;
  Vec3f step;
  Vec3f most;  ///< the window's size
  float range;

  /// Voxel indices on one axis, for four pixels with depths z. -1 if the point is below the window or the pixel hits
  /// nothing, `size` if the point is beyond the window.
  static FourInts index(float from, Four along, Four z, FourInts hits, float size) {
    const Four least = Four{-1.0f, -1.0f, -1.0f, -1.0f};
    const Four most = Four{size, size, size, size};
    const Four at = from + z * along;
    const Four low = at > least ? at : least;
    const Four high = low < most ? low : most;
    const Four kept = hits ? high : least;
    return __builtin_convertvector(kept + 1.0f, FourInts) - 1;
  }
  /// Fills out[axis] for the chunk of pixels that begins at u.
  void points(std::int32_t u, const Chunk& depths, ChunkOfVoxels& out) const {
    Four at = static_cast<float>(u) + Four{0.0f, 1.0f, 2.0f, 3.0f};
    for (std::int32_t k = 0; k < kChunk / 4; ++k) {
      const Four z = depths.fours[k];
      const FourInts hits = (z > 0.0f) & (z <= range);
      out.fours[0][k] = index(origin.x, ray.x + at * step.x, z, hits, most.x);
      out.fours[1][k] = index(origin.y, ray.y + at * step.y, z, hits, most.y);
      out.fours[2][k] = index(origin.z, ray.z + at * step.z, z, hits, most.z);
      at += 4.0f;
    }
  }
};

/// The rays of row v. The view's steps are the camera's axes, with the length of a voxel.
RowOfRays rays_of(const View& view, const Vec3& origin, const GridSpec& window, float range, std::int32_t v) {
  const double per_cell = 1.0 / window.cell;
  const Vec3 x{view.steps[0].x, view.steps[1].x, view.steps[2].x};
  const Vec3 y{view.steps[0].y, view.steps[1].y, view.steps[2].y};
  const Vec3 ahead{view.steps[0].z, view.steps[1].z, view.steps[2].z};
  const Vec3 ray = (-view.cx / view.fx) * x + ((v - view.cy) / view.fy) * y + ahead;
  // The steps are in metres per voxel. One factor makes them unit axes, the other converts metres to voxels.
  return {to_float(per_cell * origin),
          to_float((per_cell * per_cell) * ray),
          to_float((per_cell * per_cell / view.fx) * x),
          {static_cast<float>(window.dims.x), static_cast<float>(window.dims.y), static_cast<float>(window.dims.z)},
          range};
}

}  // namespace

void MapState::read_pixels(std::int32_t v) noexcept {
  const DepthView& depth = frame.image;
  const Scale scale = scale_of(depth);
  const float range = static_cast<float>(spec.range);
  const FreeDepth free{static_cast<float>(spec.depth_margin), static_cast<float>(spec.depth_margin_square), range,
                       static_cast<float>(frame.views[0].units)};
  const RowOfRays rays = rays_of(frame.views[0], frame.origin, route.spec(), range, v);
  Depth* row = frame.views[0].pyramid.row(v);
  Voxel last{-1, -1, -1};
  for (std::int32_t u = 0; u < depth.width; u += kChunk) {
    const std::int32_t count = depth.width - u < kChunk ? depth.width - u : kChunk;
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(v) * depth.stride + u;
    Chunk chunk{};
    float* z = chunk.numbers();
    depth.z16 != nullptr ? depths(depth.z16 + from, scale, count, z) : depths(depth.z32 + from, scale, count, z);
    for (std::int32_t k = 0; k < count; ++k) row[u + k] = free.of(z[k]);
    ChunkOfVoxels voxels;
    rays.points(u, chunk, voxels);
    for (std::int32_t k = 0; k < count; ++k) {
      const Voxel next{voxels.axis(0)[k], voxels.axis(1)[k], voxels.axis(2)[k]};
      // Neighbouring pixels often hit the same voxel.
      if (next.x == last.x && next.y == last.y && next.z == last.z) continue;
      last = next;
      mark_hit(next);
    }
  }
}

}  // namespace tern
