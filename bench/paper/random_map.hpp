// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_RANDOM_MAP_HPP
#define TERN_BENCH_RANDOM_MAP_HPP

#include <cstdint>

#include "host/scenario.hpp"

namespace tern_bench {

/// A family of random maps, like those of the paper's Section 4.4.
struct MapKind {
  const char* name;
  tern::Vec3 size;    ///< metres; multiples of the lattice
  double density;     ///< part of the volume that cuboids fill, before any inflation
  double resolution;  ///< of the scenario, metres
  double radius;      ///< likewise
  double least_way;   ///< between start and goal, as a part of the larger horizontal side
};

/// Corners of all cuboids lie on a lattice of this many metres, so that grids of 0.2 m and finer ones see the same map.
constexpr double kLattice = 0.2;

/// A map of that kind: cuboids of 0.6 to 2.4 m by 0.6 to 2.4 m, from 0.6 m to the whole height, standing, hanging or
/// afloat, until their union has the density. Start and goal are centres of lattice cells that keep so many cells
/// from every cuboid as the radius is wide; they need not be connected. The same seed gives the same map on every
/// machine.
tern_host::Scenario random_map(const MapKind& kind, std::uint64_t seed);

}  // namespace tern_bench

#endif
