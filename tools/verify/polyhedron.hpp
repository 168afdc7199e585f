// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far a polyhedron of half-spaces reaches. Multipliers of its half-spaces prove it (Farkas): for multipliers m >= 0
// whose half-spaces' normals sum to -n, every point p of the polyhedron has n . p >= -sum of m * offset.
#ifndef TERN_VERIFY_POLYHEDRON_HPP
#define TERN_VERIFY_POLYHEDRON_HPP

#include <optional>
#include <vector>

#include "verify/problem.hpp"

namespace tern_verify {

Point cross(const Point& a, const Point& b);

/// A keep-out, cut to where it can matter: the boundary and `reach` around it.
std::vector<HalfSpace> cut_to(const Box& boundary, const Rational& reach, std::vector<HalfSpace> planes);

/// The least of n . p over the polyhedron: the best of all proofs with three half-spaces.
std::optional<Rational> least_along(const Point& n, const std::vector<HalfSpace>& planes);

}  // namespace tern_verify

#endif
