// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/solid.hpp"

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

/// Three half-spaces. Their planes meet in the vertex.
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

/// The rest of the normal: normal + sum of multiplier * plane normal.
template <class Real>
Triple<Real> rest_of(const Solid<Real>& solid, const Triple<Real>& normal, const Combination<Real>& sum) {
  Triple<Real> rest = normal;
  for (int k = 0; k < sum.count; ++k) rest = rest + sum.multiplier[k] * solid.planes[sum.index[k]].normal;
  return rest;
}

/// The basis' multipliers for which no rest of the normal is left. A second solution corrects the rounding of the
/// first.
template <class Real>
Combination<Real> multipliers(const Solid<Real>& solid, const Basis<Real>& basis, const Triple<Real>& normal) {
  Combination<Real> sum{{basis.index[0], basis.index[1], basis.index[2], 0}, {}, 3};
  for (int k = 0; k < 3; ++k) sum.multiplier[k] = -dot(normal, basis.across[k]);
  const Triple<Real> rest = rest_of(solid, normal, sum);
  for (int k = 0; k < 3; ++k) sum.multiplier[k] = sum.multiplier[k] - dot(rest, basis.across[k]);
  return sum;
}

/// A lower bound of normal . p in the solid, less its own rounding. It is valid whatever the combination is. Negative
/// multipliers count as 0. Multipliers of the box's faces count as 0 too: the rest of the normal accounts for the box.
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
  for (int round = 0; round < 2; ++round) {  // the second turn corrects the rounding of the first
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

/// The half-space that the vertex breaks most or, if `first`, the first one that it breaks; -1 if it breaks none.
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

/// The member of the basis that half-space `entering` has to replace so that all multipliers stay >= 0; the first of
/// equals. -1 if it can replace none: then the half-spaces have no point in common.
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

/// True if `entering` and the basis, of which it can replace no member, prove that the solid is empty.
template <class Real>
bool is_empty(const Solid<Real>& solid, const Basis<Real>& basis, int entering) {
  Combination<Real> sum{{basis.index[0], basis.index[1], basis.index[2], entering}, {}, 4};
  for (int k = 0; k < 3; ++k) sum.multiplier[k] = -dot(solid.planes[entering].normal, basis.across[k]);
  sum.multiplier[3] = Real(1.0);
  const Plane<Real> nothing{{Real(0.0), Real(0.0), Real(0.0)}, Real(0.0)};
  return Real(0.0) < bound_of(solid, nothing, sum);
}

/// The box's three faces at the corner that lies furthest against the normal.
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
    // Taking the half-space that is broken most needs the fewest pivots. Later pivots take the first that is broken: by
    // Bland's rule, no basis then comes twice.
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
