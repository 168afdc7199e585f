// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the pixels that cover a cube of voxels, for eight cubes at a time, four in each register. Single precision is
// enough, because each cube is grown by the largest rounding error.
#ifndef TERN_VIEW_PROJECTOR_HPP
#define TERN_VIEW_PROJECTOR_HPP

#include <cstdint>

#include "view/four.hpp"
#include "view/view.hpp"

namespace tern {

/// A point in the camera's frame, metres.
struct Point {
  float x, y, z;
};

/// The centres of eight cubes, in two groups of four.
struct Centers {
  Four x[2], y[2], z[2];

  Point at(int k) const noexcept { return {x[k / 4][k % 4], y[k / 4][k % 4], z[k / 4][k % 4]}; }
};

/// Eight rectangles of pixels.
struct PixelBoxes {
  FourInts u0[2], u1[2], v0[2], v1[2];

  PixelBox at(int k) const noexcept { return {u0[k / 4][k % 4], u1[k / 4][k % 4], v0[k / 4][k % 4], v1[k / 4][k % 4]}; }
};

/// The pixels and depths of eight cubes.
struct Footprints {
  PixelBoxes pixels;   ///< all pixels that cover the cube; valid if it is inside
  FourInts far[2];     ///< its largest depth, in units, rounded up
  FourInts inside[2];  ///< not 0 if all of it is in front of the camera and in the image
};

/// What the footprints of all voxels in each of eight cubes have in common. A voxel is seen whole only if each pixel of
/// its footprint shows a depth behind it.
struct Cores {
  PixelBoxes pixels;   ///< each footprint meets this rectangle; valid if the cube is ahead
  FourInts common[2];  ///< not 0 if each footprint covers all of the rectangle
  FourInts far[2];     ///< the least of the voxels' largest depths, in units, rounded down
  FourInts beside[2];  ///< not 0 if no voxel is seen whole: all are behind the camera, outside the image, or beyond the
                       ///< range
  FourInts ahead[2];   ///< not 0 if all centres are in front of the camera
};

/// Projects cubes of voxels into the image of a view, in single precision.
class Projector {
 public:
  Projector() noexcept = default;
  /// `extent` is an upper bound of all coordinates, in metres: the size of the window plus its distance.
  Projector(const View& view, double extent) noexcept;

  /// True if no voxel of a box with this centre, `size` voxels large, is in the image.
  bool misses(const Point& center, const Point& size) const noexcept;
  /// Projects eight cubes of `size` voxels with these centres. cores() projects the centres of their voxels.
  Footprints footprints(const Centers& centers, float size) const noexcept;
  Cores cores(const Centers& centers, float size) const noexcept;
  /// The centres of the eight cubes of `size` voxels that make up a larger cube with this centre, x fastest.
  Centers parts(const Point& center, float size) const noexcept;
  /// The centres of eight cubes of `size` voxels in a row along x, with this point in the middle of the row.
  Centers row(const Point& center, float size) const noexcept;

 private:
  struct Axis {
    float focal, from, to;  ///< `from`, `to`: the principal point + 1/2, minus and plus rounding
    float count, last;      ///< `last` lies in the last pixel
    float least, most;      ///< tangents of the image's edges, and a little more
  };
  struct Tangents;
  struct Image {
    FourInts first, last, within;
  };
  struct Meeting {
    FourInts first, last, common, beside;
  };
  static void put(PixelBoxes& out, int n, FourInts u0, FourInts u1, FourInts v0, FourInts v1) noexcept;
  static void put(Cores& out, int n, const Meeting& u, const Meeting& v) noexcept;
  Four place_of(const Axis& axis, Four tangent) const noexcept;
  Image project(const Axis& axis, const Tangents& tangents) const noexcept;
  Meeting meet(const Axis& axis, const Tangents& tangents) const noexcept;
  static FourInts aside(const Axis& axis, Four center, Four half, Four far) noexcept;
  Footprints footprints_around(const Centers& centers, float size) const noexcept;

  Point steps_[3];
  Point half_;  ///< half the extent of a voxel along the camera's axes
  float growth_, growth_ahead_, reach_, units_;
  Axis u_, v_;
};

}  // namespace tern

#endif
