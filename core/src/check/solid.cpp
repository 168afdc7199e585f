// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "check/solid.hpp"

namespace tern {
namespace {

template <class Real>
Real larger_of(const Real& a, const Real& b) {
  return a < b ? b : a;
}

template <class Real>
Real magnitude(const Real& a) {
  return a < Real(0.0) ? -a : a;
}

double rounded(double a) {
  return a;
}

double rounded(const DoubleDouble& a) {
  return a.high;
}

/// Three half-spaces; where their planes meet is the vertex.
template <class Real>
struct Basis {
  int index[3];
  Real determinant;
  Triple<Real> across[3];  ///< rows of the inverse of the normals, transposed: vertex = sum of offset * across
};

template <class Real>
bool invert(const Solid<Real>& solid, Basis<Real>& basis) {
  const Triple<Real>& a = solid.planes[basis.index[0]].normal;
  const Triple<Real>& b = solid.planes[basis.index[1]].normal;
  const Triple<Real>& c = solid.planes[basis.index[2]].normal;
  basis.determinant = dot(a, cross(b, c));
  if (magnitude(basis.determinant) < Real(Precision<Real>::pivot)) return false;
  const Real inverse = Real(1.0) / basis.determinant;
  basis.across[0] = inverse * cross(b, c);
  basis.across[1] = inverse * cross(c, a);
  basis.across[2] = inverse * cross(a, b);
  return true;
}

/// Half-spaces by index with their multipliers.
template <class Real>
struct Combination {
  int index[4];
  Real multiplier[4];
  int count;
};

/// What the combination leaves of the normal.
template <class Real>
Triple<Real> rest_of(const Solid<Real>& solid, const Triple<Real>& normal, const Combination<Real>& sum) {
  Triple<Real> rest = normal;
  for (int k = 0; k < sum.count; ++k) rest = rest + sum.multiplier[k] * solid.planes[sum.index[k]].normal;
  return rest;
}

/// The basis' multipliers for which nothing is left of the normal; a second solution takes back the first one's
/// rounding.
template <class Real>
Combination<Real> multipliers(const Solid<Real>& solid, const Basis<Real>& basis, const Triple<Real>& normal) {
  Combination<Real> sum{{basis.index[0], basis.index[1], basis.index[2], 0}, {}, 3};
  for (int k = 0; k < 3; ++k) sum.multiplier[k] = -dot(normal, basis.across[k]);
  const Triple<Real> rest = rest_of(solid, normal, sum);
  for (int k = 0; k < 3; ++k) sum.multiplier[k] = sum.multiplier[k] - dot(rest, basis.across[k]);
  return sum;
}

/// A number that normal . p is not below in the solid, whatever the combination is; less the rounding that it may have.
/// Negative multipliers count as 0, and the box's faces as what is left of the normal.
template <class Real>
Real bound_of(const Solid<Real>& solid, const Plane<Real>& wanted, Combination<Real> sum) {
  Real total = Real(1.0);
  Real bound = Real(0.0);
  for (int k = 0; k < sum.count; ++k) {
    if (sum.index[k] >= solid.count) sum.multiplier[k] = Real(0.0);
    sum.multiplier[k] = larger_of(sum.multiplier[k], Real(0.0));
    total = total + sum.multiplier[k];
    bound = bound - sum.multiplier[k] * solid.planes[sum.index[k]].offset;
  }
  const Triple<Real> rest = rest_of(solid, wanted.normal, sum);
  bound = bound - magnitude(rest.x) * Real(solid.half[0]);
  bound = bound - magnitude(rest.y) * Real(solid.half[1]);
  bound = bound - magnitude(rest.z) * Real(solid.half[2]);
  const Real scale = total * Real(solid.reach) + magnitude(wanted.offset);
  return bound - Real(Precision<Real>::rounding) * scale;
}

template <class Real>
Triple<Real> vertex_of(const Solid<Real>& solid, const Basis<Real>& basis) {
  Triple<Real> vertex{Real(0.0), Real(0.0), Real(0.0)};
  for (int round = 0; round < 2; ++round) {  // a second solution takes back the first one's rounding
    Triple<Real> correction{Real(0.0), Real(0.0), Real(0.0)};
    for (int k = 0; k < 3; ++k) {
      const Plane<Real>& plane = solid.planes[basis.index[k]];
      correction = correction + (plane.offset - dot(plane.normal, vertex)) * basis.across[k];
    }
    vertex = vertex + correction;
  }
  return vertex;
}

template <class Real>
bool is_member(const Basis<Real>& basis, int plane) {
  return plane == basis.index[0] || plane == basis.index[1] || plane == basis.index[2];
}

/// The half-space that the vertex breaks most, or the first that it breaks; -1 where it is in all.
template <class Real>
int broken_at(const Solid<Real>& solid, const Basis<Real>& basis, bool first) {
  const Triple<Real> vertex = vertex_of(solid, basis);
  int worst = -1;
  Real excess = Real(Precision<Real>::feasible * solid.reach);
  for (int p = 0; p < solid.count + kSolidFaces; ++p) {
    if (is_member(basis, p)) continue;
    const Real beyond = dot(solid.planes[p].normal, vertex) - solid.planes[p].offset;
    if (!(excess < beyond)) continue;
    excess = beyond;
    worst = p;
    if (first) break;
  }
  return worst;
}

/// The member of the basis that has to leave for half-space `entering` so that all multipliers stay >= 0, the first of
/// equals; -1 where none can: the half-spaces have no point in common.
template <class Real>
int leaving(const Basis<Real>& basis, const Combination<Real>& sum, const Triple<Real>& entering) {
  int best = -1;
  Real best_share = Real(0.0);
  Real best_multiplier = Real(0.0);
  for (int k = 0; k < 3; ++k) {
    const Real share = dot(entering, basis.across[k]);
    if (!(Real(Precision<Real>::pivot) < share * magnitude(basis.determinant))) continue;
    const Real multiplier = larger_of(sum.multiplier[k], Real(0.0));
    if (best >= 0 && !(multiplier * best_share < best_multiplier * share)) continue;
    best = k;
    best_share = share;
    best_multiplier = multiplier;
  }
  return best;
}

/// True where `entering` and the basis, whose planes it cannot replace, prove that the solid has no point at all.
template <class Real>
bool is_empty(const Solid<Real>& solid, const Basis<Real>& basis, int entering) {
  Combination<Real> sum{{basis.index[0], basis.index[1], basis.index[2], entering}, {}, 4};
  for (int k = 0; k < 3; ++k) sum.multiplier[k] = -dot(solid.planes[entering].normal, basis.across[k]);
  sum.multiplier[3] = Real(1.0);
  const Plane<Real> nothing{{Real(0.0), Real(0.0), Real(0.0)}, Real(0.0)};
  return Real(0.0) < bound_of(solid, nothing, sum);
}

/// The box's faces that a point furthest against the normal is on.
template <class Real>
Basis<Real> first_basis(const Solid<Real>& solid, const Triple<Real>& normal) {
  Basis<Real> basis{};
  const Real along[3] = {normal.x, normal.y, normal.z};
  for (int a = 0; a < 3; ++a) basis.index[a] = solid.count + 2 * a + (along[a] < Real(0.0) ? 0 : 1);
  return basis;
}

}  // namespace

template <class Real>
double shortfall(const Solid<Real>& solid, const Plane<Real>& wanted) noexcept {
  Basis<Real> basis = first_basis(solid, wanted.normal);
  double missing = 2.0 * solid.reach;  // while there is no bound
  const int most = 2 * (solid.count + kSolidFaces);
  for (int pivot = 0; pivot < 2 * most; ++pivot) {
    if (!invert(solid, basis)) return missing;
    const Combination<Real> sum = multipliers(solid, basis, wanted.normal);
    const Real bound = bound_of(solid, wanted, sum);
    if (!(bound < wanted.offset)) return 0.0;
    missing = rounded(wanted.offset - bound);
    // The worst half-space leads there soonest; by Bland's rule, the first of all, no sequence of bases comes again.
    const int entering = broken_at(solid, basis, pivot >= most);
    if (entering < 0) return missing;
    const int out = leaving(basis, sum, solid.planes[entering].normal);
    if (out < 0) return is_empty(solid, basis, entering) ? 0.0 : missing;
    basis.index[out] = entering;
  }
  return missing;
}

template double shortfall(const Solid<double>&, const Plane<double>&) noexcept;
template double shortfall(const Solid<DoubleDouble>&, const Plane<DoubleDouble>&) noexcept;

}  // namespace tern
