// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keep-outs as solids: distance by trying every face, edge and corner.
#ifndef TERN_TESTS_ATTACK_SOLID_HPP
#define TERN_TESTS_ATTACK_SOLID_HPP

#include "attack/curve.hpp"
#include "attack/world.hpp"

namespace tern_attack {

/// The points p with normal . p <= offset; unit normal, local frame.
struct Plane {
  Point normal;
  Real offset;
};

std::vector<Plane> planes_of(const World& world, const tern::Fence& fence);

/// A keep-out as far as it lies in the boundary grown by the radius and a voxel.
class Solid {
 public:
  Solid(const World& world, const tern::Fence& fence);

  /// Distance from a point: to the nearest point of any face, edge or corner; inside it minus the depth. 1e30 where no
  /// such point was found (a solid without points, or one too thin for long double). `nearest` where given.
  Real distance(const Point& p, Point* nearest = nullptr) const;
  /// Proves that the whole curve keeps `least`.
  Verdict keeps(const Curve& curve, Real least) const;

 private:
  struct Edge {
    Point on;
    Point along;
  };
  void find_edges();
  void find_corners();
  bool holds(const Point& p) const;
  bool apart(const Curve& curve, Real least) const;

  std::vector<Plane> planes_;
  std::vector<Edge> edges_;
  std::vector<Point> corners_;
};

}  // namespace tern_attack

#endif
