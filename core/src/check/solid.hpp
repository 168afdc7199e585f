// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proves that a keep-out lies beyond a plane: a linear programme by the dual simplex method. What it believes is not
// the simplex method but the multipliers that it finds. For any multipliers >= 0,
//
//   normal . p  >=  -(sum of multiplier * offset) - |rest| . half     for all p in the solid,
//   rest = normal + sum of multiplier * plane normal,
//
// since the solid lies in the box of half edges `half`: what the multipliers leave of the normal costs its share of
// the box. Nearly parallel planes, a poor pivot or a wrong turn can therefore weaken a bound, but never make it false.
#ifndef TERN_CHECK_SOLID_HPP
#define TERN_CHECK_SOLID_HPP

#include "base/double_double.hpp"
#include "base/math.hpp"
#include "base/triple.hpp"
#include "tern/config.hpp"

namespace tern {

/// normal . p <= offset.
template <class Real>
struct Plane {
  Triple<Real> normal;
  Real offset;
};

constexpr int kSolidFaces = 6;

/// A convex solid: half-spaces, and the box about the frame's origin that it is cut by. Normals are unit vectors but
/// for a few units in the last place of a double; no offset is greater than `reach`.
template <class Real>
struct Solid {
  int count;                                          ///< half-spaces, without the box
  bool empty;                                         ///< some half-space has nothing of the box
  double half[3];                                     ///< of the box, metres
  double reach;                                       ///< of a ball that holds the box, metres
  Plane<Real> planes[kMaxFencePlanes + kSolidFaces];  ///< the box's faces last: +x, -x, +y ...
};

/// What a number type can tell apart. `feasible`, in parts of the reach: a point so little outside a half-space counts
/// as in it. `pivot`: the least volume that three unit normals span. `rounding`: the error of a bound, in parts of the
/// reach times 1 + the sum of the multipliers. A bound is 4 products and 4 sums for each of 3 components, and as many
/// for the offsets; with the planes' own rounding that is at most 32 units of the last place, half an ulp each.
template <class Real>
struct Precision;
template <>
struct Precision<double> {
  static constexpr double feasible = 1e-14;
  static constexpr double pivot = 1e-14;
  static constexpr double rounding = 32.0 / 9007199254740992.0;  // 2^-53
};
template <>
struct Precision<DoubleDouble> {
  static constexpr double feasible = 1e-20;
  static constexpr double pivot = 1e-28;
  static constexpr double rounding = 32.0 / 9007199254740992.0 / 562949953421312.0;  // 2^-53 2^-49
};

/// By how much normal . p >= wanted.offset is not proven for all of the solid, wanted.normal being a unit vector: 0
/// where it is, else metres > 0. At most 4 (count + 6) pivots.
template <class Real>
double shortfall(const Solid<Real>& solid, const Plane<Real>& wanted) noexcept;

extern template double shortfall(const Solid<double>&, const Plane<double>&) noexcept;
extern template double shortfall(const Solid<DoubleDouble>&, const Plane<DoubleDouble>&) noexcept;

/// True where it is proven.
template <class Real>
bool lies_beyond(const Solid<Real>& solid, const Plane<Real>& wanted) noexcept {
  return !(shortfall(solid, wanted) > 0.0);
}

}  // namespace tern

#endif
