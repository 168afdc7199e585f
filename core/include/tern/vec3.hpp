// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points, voxels and boxes: plain data with a fixed layout, the same in C and C++. Nothing is checked or initialised
// here; each function that takes one of these says what it accepts.
#ifndef TERN_VEC3_HPP
#define TERN_VEC3_HPP

#include <stdint.h>

namespace tern {

/// A point or a vector. Frame and unit are stated where it is used: positions in metres, velocities in m/s and so on.
/// All frames are right-handed with z up.
struct Vec3 {
  double x;
  double y;
  double z;
};

/// Integer coordinates of a voxel. (0, 0, 0) is the voxel at the grid's lower corner.
struct Voxel {
  int32_t x;
  int32_t y;
  int32_t z;
};

/// An axis-aligned closed box with lower <= upper on every axis, in metres. A box without extent along an axis is
/// allowed: it is a plate, a rod or a point.
struct Box {
  Vec3 lower;
  Vec3 upper;
};

}  // namespace tern

#endif
