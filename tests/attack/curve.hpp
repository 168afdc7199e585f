// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_ATTACK_CURVE_HPP
#define TERN_TESTS_ATTACK_CURVE_HPP

#include <vector>

#include "attack/exact.hpp"

namespace tern_attack {

/// Bernstein coefficients of a curve, or of the piece of one that lies within [from, to] of the parameter.
struct Curve {
  int degree;
  Point p[tern::kControlPoints];
  Real from;
  Real to;

  const Point& first() const { return p[0]; }
  const Point& last() const { return p[degree]; }
};

/// The curve of a segment's or a track's control points, moved by `shift`.
Curve curve_of(const tern::Vec3* points, const Point& shift = {});
Curve line(const Point& from, const Point& to);
/// Derivative with respect to time of a curve that lasts `duration`.
Curve derivative(const Curve& curve, Real duration);
/// The halves of a piece.
void split(const Curve& curve, Curve& left, Curve& right);
/// What lies between two parameters, 0 <= from <= to <= 1, as a curve of its own.
Curve between(const Curve& curve, Real from, Real to);
/// The value at u within [0, 1] of the piece.
Point value(const Curve& curve, Real u);
/// Largest coordinate, and largest length, of all coefficients.
Real magnitude(const Curve& curve);
Real longest(const Curve& curve);

struct Verdict {
  Proof proof;
  Real where;  ///< parameter of the point that breaks the rule, or of the piece that is not decided
};

/// Proves a convex rule for all of a curve: a piece is proven where `holds` is true of all its coefficients (their hull
/// holds the curve), and broken where it is false of an end.
template <class Rule>
Verdict prove(const Curve& whole, const Rule& holds) {
  constexpr int kMostPieces = 20000;
  std::vector<Curve> open{whole};
  for (int pieces = 0; !open.empty(); ++pieces) {
    const Curve curve = open.back();
    open.pop_back();
    bool inside = true;
    for (int i = 0; i <= curve.degree && inside; ++i) inside = holds(curve.p[i]);
    if (inside) continue;
    if (!holds(curve.first())) return {Proof::kBroken, curve.from};
    if (!holds(curve.last())) return {Proof::kBroken, curve.to};
    if (pieces == kMostPieces) return {Proof::kUnproven, curve.from};
    Curve left;
    Curve right;
    split(curve, left, right);
    open.push_back(right);
    open.push_back(left);
  }
  return {Proof::kProven, 0};
}

}  // namespace tern_attack

#endif
