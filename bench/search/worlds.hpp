// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps and queries that searches are measured on.
#ifndef TERN_BENCH_WORLDS_HPP
#define TERN_BENCH_WORLDS_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "host/scenario.hpp"
#include "tern/grid.hpp"

namespace tern_bench {

/// A grid with its storage. Not to be copied: the grid points into the words.
struct World {
  World() = default;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  std::vector<std::uint64_t> words;
  tern::Grid grid;
};

/// Between two free voxels.
struct Query {
  tern::Voxel start;
  tern::Voxel goal;
};

/// Lays out, fills and inflates a scenario's grid, and tells its query; an end whose voxel is not free moves to the
/// free voxel nearest to it. Throws std::runtime_error.
Query build(const tern_host::Scenario& scenario, World& world);

/// One configuration of the paper's Monte Carlo experiment (section 4.4).
struct ForestKind {
  const char* name;
  tern::Vec3 size;  ///< metres
  double density;   ///< part of the volume that cuboids fill
};

/// A map of that kind with a query between two random free voxels further apart than 30 % of its width. Cuboids are
/// 0.4 to 2 m wide on a lattice of 0.2 m, so that both cell sizes see the same map; the robot is a point.
Query build(const ForestKind& kind, std::uint64_t seed, double cell, World& world);

/// A map and its queries from the public 3D voxel benchmark ("name.3dmap" and "name.3dmap.3dscen").
std::vector<Query> build_voxel_benchmark(const std::string& map_file, World& world);

}  // namespace tern_bench

#endif
