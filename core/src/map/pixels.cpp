// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pixels of a depth image. Each gives a depth up to which its cone is free, and a voxel that is hit. Single precision
// is enough: the depth is rounded towards the camera, and a hit is off by less than a thousandth of a voxel.
#include "base/math.hpp"
#include "base/work.hpp"
#include "map/map_state.hpp"
#include "map/support.hpp"

namespace tern {
namespace {

/// Pixels that are processed together.
constexpr std::int32_t kChunk = 64;
/// Depths of a chunk.
struct Chunk {
  Four fours[kChunk / 4];
  float* numbers() { return reinterpret_cast<float*>(fours); }
};
/// The number of a saturated pixel.
constexpr float kSaturated = 65535.0f;

/// Converts the numbers of an image to depths in metres. A pixel without a measurement becomes 0. The comparisons are
/// separate selections, which the compiler can vectorise.
struct Scale {
  float unit, min, max;
  bool no_return;  ///< a pixel of 0 or infinity becomes kNoReturn

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
  if (!scale.no_return) return;
  for (std::int32_t k = 0; k < count; ++k) {
    const float number = static_cast<float>(numbers[k]);
    const bool is_none = (number >= 0.0f && number <= 0.0f) || number >= kNoReturn;
    if (is_none) z[k] = kNoReturn;
  }
}

Scale scale_of(const DepthView& view) {
  const float unit = static_cast<float>(view.scale);
  const float max = static_cast<float>(view.max);
  const float saturated = kSaturated * unit;
  return {unit, static_cast<float>(view.min), view.z16 != nullptr && saturated < max ? saturated : max,
          view.no_return > 0.0};
}

/// Reads the depths of `count` pixels of row v from u on.
void read_depths(const DepthView& view, const Scale& scale, std::int32_t u, std::int32_t v, std::int32_t count,
                 float* z) {
  const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(v) * view.stride + u;
  view.z16 != nullptr ? depths(view.z16 + from, scale, count, z) : depths(view.z32 + from, scale, count, z);
}

/// A chunk of one row with the pixels beside it; NaN beyond the image's edges.
struct WideChunk {
  float z[kChunk + 2];

  void read(const DepthView& view, const Scale& scale, std::int32_t u, std::int32_t v, std::int32_t count) {
    for (float& depth : z) depth = __builtin_nanf("");
    if (v < 0 || v >= view.height) return;
    const std::int32_t first = u > 0 ? u - 1 : 0;
    const std::int32_t end = u + count < view.width ? u + count + 1 : view.width;
    read_depths(view, scale, first, v, end - first, z + (first - (u - 1)));
  }
};

/// Judges each pixel of a chunk by its neighbours: the depth up to which it sees, and the depth that it hits.
void judge_chunk(const DepthView& view, const Scale& scale, const Support& support, std::int32_t u, std::int32_t v,
                 std::int32_t count, float* sees, float* hits) {
  WideChunk rows[3];
  for (std::int32_t k = 0; k < 3; ++k) rows[k].read(view, scale, u, v + k - 1, count);
  for (std::int32_t k = 0; k < count; ++k) {
    const float* const around[3] = {rows[0].z + k, rows[1].z + k, rows[2].z + k};
    const Judged judged = scale.no_return ? judge_pixel<true>(support, around[0], around[1], around[2])
                                          : judge_pixel<false>(support, around[0], around[1], around[2]);
    sees[k] = judged.sees;
    hits[k] = judged.hits;
  }
}

/// Converts a measured depth to the depth that is certainly free, in units of Depth. It subtracts one unit for
/// rounding.
struct FreeDepth {
  float margin, margin_square, range, units;

  Depth of(float z) const { return up_to(z - (margin + margin_square * z * z)); }
  Depth up_to(float metres) const {
    metres = metres < range ? metres : range;
    const float whole = metres * units - 1.0f;
    return static_cast<Depth>(static_cast<std::int32_t>(whole > 0.0f ? whole : 0.0f));
  }
  /// A loop of its own for pixels without a return: with a choice in the other one, the compiler vectorises neither.
  void convert(const float* z, std::int32_t count, const DepthView& view, Depth* out) const {
    for (std::int32_t k = 0; k < count; ++k) out[k] = of(z[k]);
    if (!(view.no_return > 0.0)) return;
    const Depth free = up_to(static_cast<float>(view.no_return));
    for (std::int32_t k = 0; k < count; ++k) out[k] = z[k] < kNoReturn ? out[k] : free;
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
  float range;

  /// Marks the voxels that a chunk's pixels hit. The chunk begins at pixel u.
  void mark(std::int32_t u, const Chunk& depths, HitWriter& writer) const {
    Four at = static_cast<float>(u) + Four{0.0f, 1.0f, 2.0f, 3.0f};
    for (const Four& z : depths.fours) {
      const FourInts hits = (z > 0.0f) & (z <= range);
      const Four cells[3] = {origin.x + z * (ray.x + at * step.x), origin.y + z * (ray.y + at * step.y),
                             origin.z + z * (ray.z + at * step.z)};
      if (any(hits)) writer.add(cells, hits);
      at += 4.0f;
    }
  }
};

/// The rays of row v. The view's steps are the camera's axes, with the length of a voxel.
RowOfRays rays_of(const View& view, const Vec3& origin, double cell, float range, std::int32_t v) {
  const double per_cell = 1.0 / cell;
  const Vec3 x{view.steps[0].x, view.steps[1].x, view.steps[2].x};
  const Vec3 y{view.steps[0].y, view.steps[1].y, view.steps[2].y};
  const Vec3 ahead{view.steps[0].z, view.steps[1].z, view.steps[2].z};
  const Vec3 ray = (-view.cx / view.fx) * x + ((v - view.cy) / view.fy) * y + ahead;
  // The steps are in metres per voxel. One factor makes them unit axes, the other converts metres to voxels.
  return {to_float(per_cell * origin), to_float((per_cell * per_cell) * ray),
          to_float((per_cell * per_cell / view.fx) * x), range};
}

}  // namespace

void MapState::read_pixels(std::int32_t v, Work& work) noexcept {
  work.spend(pixels_operations(frame.image.width));
  const DepthView& depth = frame.image;
  const Scale scale = scale_of(depth);
  const float range = static_cast<float>(spec.range);
  const FreeDepth free{static_cast<float>(spec.depth_margin), static_cast<float>(spec.depth_margin_square), range,
                       static_cast<float>(frame.views[0].units)};
  const Support support{static_cast<float>(spec.cell), free.margin, free.margin_square, spec.support};
  const RowOfRays rays = rays_of(frame.views[0], frame.origin, spec.cell, range, v);
  Depth* row = frame.views[0].pyramid.row(v);
  HitWriter writer = hit_writer();
  for (std::int32_t u = 0; u < depth.width; u += kChunk) {
    const std::int32_t count = depth.width - u < kChunk ? depth.width - u : kChunk;
    Chunk chunk;
    float* const hits = chunk.numbers();
    for (std::int32_t k = count; k < kChunk; ++k) hits[k] = 0.0f;
    float wary[kChunk];
    const float* sees = hits;
    if (support.least > 0) {
      judge_chunk(depth, scale, support, u, v, count, wary, hits);
      sees = wary;
    } else {
      read_depths(depth, scale, u, v, count, hits);
    }
    free.convert(sees, count, depth, row + u);
    rays.mark(u, chunk, writer);
  }
}

}  // namespace tern
