// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A pinhole view of the window.
#ifndef TERN_VIEW_VIEW_HPP
#define TERN_VIEW_VIEW_HPP

#include <cstdint>

#include "grid/lattice.hpp"
#include "tern/map.hpp"
#include "tern/vec3.hpp"
#include "view/depth_pyramid.hpp"

namespace tern {

/// Half the width of a scan's view, as a tangent. The view looks at a face of a cube around the sensor. A half width of
/// 1 would show the face alone. A wider view overlaps with the views beside it, so that a cube near an edge lies wholly
/// in one of them.
constexpr double kFaceTangent = 1.5;
/// A scan's view is bent: tangent t is at t / (1 + kFaceBend * |t|) in the image. Its pixels therefore cover about
/// equal angles. On the face itself, they are 0.66 to 1.19 times as wide as in its middle. Pixels of a pinhole view
/// would be 0.33 to 1 times as wide.
constexpr double kFaceBend = 0.4142;

/// The bent tangent, for a tangent >= 0.
inline double bent(double tangent) noexcept {
  return tangent / (1.0 + kFaceBend * tangent);
}

/// A camera with axes x, y across and z ahead. All lengths in metres; `steps` and `corner` in the camera's frame.
///
/// Depths are along z. In the view of a scan, they are distances from the sensor.
struct View {
  Vec3 steps[3];  ///< from one voxel to the next along the window's x, y and z
  Vec3 corner;    ///< lower corner of the window's voxel (0, 0, 0)
  double fx, fy, cx, cy;
  std::int32_t width, height;
  double growth;        ///< added to every cube on all sides, for the error of the position
  double growth_ahead;  ///< added to `growth` for each metre of depth, for the error of the angle
  double reach;         ///< sine of the angle by which outlines are widened, > 0 in the view of a scan alone
  double units;         ///< depth units per metre
  DepthPyramid pyramid;

  /// Transforms a point of the window, in voxels, into the camera's frame.
  Vec3 at(double x, double y, double z) const noexcept;
};

/// Sets the view's geometry from camera axes in the world (unit vectors) and the centre in the window's local frame.
void place(View& view, const Vec3 (&axes)[3], const Vec3& local_center, double cell) noexcept;

/// A box of voxels.
struct VoxelBox {
  IndexRange x, y, z;
};
/// The window's voxels that a view to depth `range` can reach, including the camera's own and one more on each side;
/// empty ranges if there are none.
VoxelBox reach(const View& view, double range, const GridSpec& window) noexcept;

}  // namespace tern

#endif
