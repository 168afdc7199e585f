// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far a polyhedron of half-spaces reaches. Multipliers of its half-spaces prove it (Farkas): for multipliers m >= 0
// whose half-spaces' normals sum to -n, every point p of the polyhedron has n . p >= -sum of m * offset.
#ifndef TERN_VERIFY_POLYHEDRON_HPP
#define TERN_VERIFY_POLYHEDRON_HPP

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "verify/problem.hpp"

namespace tern_verify {

Point cross(const Point& a, const Point& b);

/// A keep-out, cut to where it can matter: the boundary and `reach` around it.
std::vector<HalfSpace> cut_to(const Box& boundary, const Rational& reach, std::vector<HalfSpace> planes);

/// How far a polyhedron reaches in many directions.
class Extent {
 public:
  /// A half-space, and its normal of length 1 and offset to match.
  struct Plane {
    HalfSpace exact;
    Guess normal;
    double offset;
  };

  Extent() = default;
  explicit Extent(const std::vector<HalfSpace>& planes);

  /// The least of n . p over the polyhedron: the best of all proofs with three half-spaces.
  std::optional<Rational> least_along(const Point& n) const;

  const std::vector<Plane>& planes() const { return planes_; }

 private:
  /// Three of the planes; their multipliers for n are -n . row, each.
  struct Triple {
    std::array<std::size_t, 3> planes;
    std::array<Guess, 3> rows;
  };
  /// A triple, and what it may prove.
  struct Candidate {
    const Triple* triple;
    bool is_likely;  ///< no multiplier seems to be negative
    double least;
  };

  bool holds(const Point& point) const;
  void add(std::size_t i, std::size_t j, std::size_t k);
  Candidate candidate(const Triple& triple, const Guess& n) const;

  std::vector<Plane> planes_;
  std::vector<Triple> triples_;
};

}  // namespace tern_verify

#endif
