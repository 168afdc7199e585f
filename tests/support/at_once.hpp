// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parts of stages that the planner runs in slices, each in one call.
#ifndef TERN_TESTS_SUPPORT_AT_ONCE_HPP
#define TERN_TESTS_SUPPORT_AT_ONCE_HPP

#include <cstdint>

#include "corridor/grow.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "grid/distance.hpp"
#include "grid/local_boxes.hpp"

namespace tern_test {

/// Grows a polyhedron. kOk, or why it failed.
inline tern::Status grow_polyhedron(const tern::World& world, const tern::Vec3& from, const tern::Vec3& to,
                                    tern::GrowScratch& scratch, tern::Polyhedron& out) {
  tern::Growth growth;
  grow_begin(growth, world, from, to);
  tern::Work all{0xFFFFFFFFu};
  grow_advance(growth, world, scratch, out, all);
  return growth.status;
}

inline tern::EllipsoidFrame fit_ellipsoid(const tern::Vec3& from, const tern::Vec3& to,
                                          const tern::Obstacles& obstacles, double cell, std::int32_t* inside) {
  tern::EllipsoidFit fit;
  fit_begin(fit, from, to, cell);
  tern::Work all{0xFFFFFFFFu};
  fit_advance(fit, obstacles, inside, all);
  return fit.frame;
}

/// The number of boxes; -1 if they do not fit.
inline int extract_local_boxes(const tern::Grid& grid, const tern::VoxelRange& range, tern::ExtractScratch& scratch,
                               tern::LocalBox* boxes) {
  tern::Work all{0xFFFFFFFFu};
  extract_begin(range, scratch);
  return extract_advance(grid, scratch, boxes, all) == tern::Progress::kDone ? scratch.count : -1;
}

/// False, with `out` unchanged, if no voxel is free.
inline bool nearest_free_voxel(const tern::Grid& grid, const tern::Vec3& local, tern::Voxel& out) {
  tern::NearestFree nearest;
  tern::Work all{0xFFFFFFFFu};
  nearest_begin(nearest, grid, local);
  nearest_advance(nearest, grid, all);
  if (nearest.found) out = nearest.voxel;
  return nearest.found;
}

}  // namespace tern_test

#endif
