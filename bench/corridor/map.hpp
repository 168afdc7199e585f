// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps of the corridor benchmark: cuboids on a grid, and what of their voxels a box or a polyhedron holds.
#ifndef TERN_BENCH_CORRIDOR_MAP_HPP
#define TERN_BENCH_CORRIDOR_MAP_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "support/corridor_case.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"

namespace tern_bench {

/// A case's map as a grid of voxels of 0.1 m, radius 0. The grid is a view of `words`.
struct Map {
  std::vector<std::uint64_t> words;
  tern::Grid grid;
  std::vector<tern::Vec3> surface;  ///< centres of the obstacle voxels with a face that no other covers
};

std::unique_ptr<Map> lay_out(const tern_test::CorridorCase& c);

/// The bounding box of a segment and `margin` metres more on every side.
tern::Box around(const tern::Vec3& a, const tern::Vec3& b, double margin);

/// How many surface voxels have their centre in the box.
double count_surface(const Map& map, const tern::Box& box);

/// Cubic metres of the polyhedron inside obstacle voxels, taken as solid cubes.
double unsafe_volume(const Map& map, const tern::Polyhedron& polyhedron);

}  // namespace tern_bench

#endif
