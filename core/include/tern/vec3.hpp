// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_VEC3_HPP
#define TERN_VEC3_HPP

#include <stdint.h>

namespace tern {

/// A point or vector in metres (or metres per second, ...), plain data with a fixed layout.
struct Vec3 {
  double x;
  double y;
  double z;
};

/// A voxel's integer coordinates in a grid, counted from the grid's lower corner.
struct Voxel {
  int32_t x;
  int32_t y;
  int32_t z;
};

/// An axis-aligned box, lower <= upper on every axis; a zero extent is a plate, a rod or a point.
struct Box {
  Vec3 lower;
  Vec3 upper;
};

}  // namespace tern

#endif
