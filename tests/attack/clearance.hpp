// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distance between curves and obstacle cubes as solids, proven for all of a curve.
#ifndef TERN_TESTS_ATTACK_CLEARANCE_HPP
#define TERN_TESTS_ATTACK_CLEARANCE_HPP

#include "attack/curve.hpp"
#include "attack/world.hpp"

namespace tern_attack {

/// Distance between a point (local frame) and the closed cube of a voxel; inside it minus the depth.
Real cube_distance(const World& world, const tern::Voxel& voxel, const Point& p);

struct Clearance {
  Proof proof;
  Real where;         ///< parameter of the curve where the rule is broken or undecided
  Real distance;      ///< there, to the voxel
  tern::Voxel voxel;  ///< the obstacle that it is about
};

/// Decides whether the whole curve (local frame) keeps `least` from every obstacle. A curve that goes deeper than
/// -`least` into an obstacle breaks a negative one.
Clearance clearance(const World& world, const Curve& curve, Real least);

}  // namespace tern_attack

#endif
