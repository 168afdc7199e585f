// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A pinhole view of the window: which pixels cover a cube of voxels, and whether all of it is in front of them.
#ifndef TERN_MAP_VIEW_HPP
#define TERN_MAP_VIEW_HPP

#include <cstdint>

#include "grid/lattice.hpp"
#include "map/depth_pyramid.hpp"
#include "tern/map.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// How a cube of voxels lies to what a view saw.
enum class Sight : std::uint8_t {
  kNone,  ///< no voxel of it was seen whole
  kPart,  ///< unknown: some may have been
  kAll,   ///< the whole cube was in front of every pixel that covers it
};

/// A camera with axes x, y across and z ahead. All lengths in metres; `steps` and `corner` in the camera's frame.
struct View {
  Vec3 steps[3];  ///< from one voxel to the next along the window's x, y and z
  Vec3 corner;    ///< lower corner of the window's voxel (0, 0, 0)
  Vec3 half;      ///< half the extent of a voxel along each axis of the camera
  double fx, fy, cx, cy;
  std::int32_t width, height;
  double growth;        ///< added to every cube on all sides: the pose's error,
  double growth_ahead;  ///< and by a metre of depth the angle's
  double units;         ///< depth units a metre
  DepthPyramid pyramid;

  /// The centre of a cube of `size` voxels whose lowest one is given, camera frame.
  Vec3 center(const Voxel& lowest, double size) const noexcept;
  /// What the view saw of the cube.
  Sight look(const Voxel& lowest, std::int32_t size) const noexcept;
};

/// Sets the view's geometry from camera axes in the world (unit vectors) and the centre in the window's local frame.
void place(View& view, const Vec3 (&axes)[3], const Vec3& local_center, double cell) noexcept;

/// The window's voxels that a view to depth `range` can reach, camera and one voxel more included; empty ranges where
/// there is none.
struct VoxelBox {
  IndexRange x, y, z;
};
VoxelBox reach(const View& view, double range, const GridSpec& window) noexcept;

}  // namespace tern

#endif
