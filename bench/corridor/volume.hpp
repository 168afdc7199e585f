// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes of polyhedra for the benchmarks: exact but for rounding, by cutting facets; nothing of the core's own.
#ifndef TERN_BENCH_CORRIDOR_VOLUME_HPP
#define TERN_BENCH_CORRIDOR_VOLUME_HPP

#include <vector>

#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern_bench {

/// The half-spaces that bound the polyhedron.
std::vector<tern::Halfspace> bounding_planes(const tern::Polyhedron& polyhedron);

/// The six half-spaces of a box.
std::vector<tern::Halfspace> planes_of(const tern::Box& box);

/// Cubic metres of the intersection of half-spaces, which must be bounded by 1e4 m around the origin; 0 where they
/// have no interior.
double volume(const std::vector<tern::Halfspace>& planes);

}  // namespace tern_bench

#endif
