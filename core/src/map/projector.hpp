// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the pixels that cover a cube of voxels, for eight cubes at a time, four in each register. Single precision is
// enough, because each cube is grown by the largest rounding error.
#ifndef TERN_MAP_PROJECTOR_HPP
#define TERN_MAP_PROJECTOR_HPP

#include <cstdint>

#include "map/view.hpp"

namespace tern {

/// Four numbers, which fit a register of SSE2 or NEON.
using Four __attribute__((vector_size(16), __may_alias__)) = float;
using FourInts __attribute__((vector_size(16), __may_alias__)) = std::int32_t;

/// A point in the camera's frame, metres.
struct Point {
  float x, y, z;
};

/// The centres of eight cubes, in two groups of four.
struct Centers {
  Four x[2], y[2], z[2];

  Point at(int k) const noexcept { return {x[k / 4][k % 4], y[k / 4][k % 4], z[k / 4][k % 4]}; }
};

/// Where eight cubes lie in an image.
struct Footprints {
  FourInts u0[2], u1[2], v0[2], v1[2];  ///< pixels that cover the cube; valid if it is inside
  FourInts near[2], far[2];             ///< its least depth, rounded down, and its largest, rounded up; in units
  FourInts beside[2];                   ///< not 0 if it is behind the camera, outside the image, or beyond the range
  FourInts inside[2];                   ///< not 0 if all of it is in front of the camera and in the image

  PixelBox pixels(int k) const noexcept {
    return {u0[k / 4][k % 4], u1[k / 4][k % 4], v0[k / 4][k % 4], v1[k / 4][k % 4]};
  }
};

/// Projects cubes of voxels into the image of a view, in single precision.
class Projector {
 public:
  Projector() noexcept = default;
  /// `extent` is an upper bound of all coordinates, in metres: the size of the window plus its distance.
  Projector(const View& view, double extent) noexcept;

  /// Where cubes of `size` voxels with these centres lie in the image.
  Footprints project(const Centers& centers, float size) const noexcept;
  /// The centres of the eight cubes of `size` voxels that make up a larger cube with this centre, x fastest.
  Centers parts(const Point& center, float size) const noexcept;
  /// The centres of eight cubes of `size` voxels in a row along x, with this point in the middle of the row.
  Centers row(const Point& center, float size) const noexcept;

 private:
  struct Axis {
    float focal, from, to, count;  ///< `from`, `to`: the principal point + 1/2, minus and plus rounding
  };
  struct Image {
    FourInts first, last, beside, within;
  };
  static Image project_axis(const Axis& axis, Four center, Four half, Four by_near, Four by_far) noexcept;

  Point steps_[3];
  Point half_;  ///< half the extent of a voxel along the camera's axes
  float growth_, growth_ahead_, units_;
  Axis u_, v_;
};

}  // namespace tern

#endif
