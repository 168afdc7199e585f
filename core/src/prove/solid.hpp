// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proves that a keep-out lies beyond a plane: a linear programme by the dual simplex method. The proof does not rest on
// the simplex method, but on the multipliers that it finds. For any multipliers >= 0,
//
//   normal . p  >=  -(sum of multiplier * offset) - |rest| . half     for all p in the solid,
//   rest = normal + sum of multiplier * plane normal,
//
// because the solid lies in the box of half edges `half`. Nearly parallel planes, a poor pivot or a wrong turn can
// therefore weaken a bound, but never make it false.
#ifndef TERN_PROVE_SOLID_HPP
#define TERN_PROVE_SOLID_HPP

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

/// A convex solid: the points that several half-spaces and a box about the frame's origin share. Normals are unit
/// vectors to a few units in the last place of a double. No offset is greater than `reach`.
template <class Real>
struct Solid {
  int count;                                          ///< half-spaces, without the box
  bool empty;                                         ///< some half-space contains no point of the box
  double half[3];                                     ///< of the box, metres
  double reach;                                       ///< of a ball that holds the box, metres
  Plane<Real> planes[kMaxFencePlanes + kSolidFaces];  ///< the box's faces last: +x, -x, +y ...
};

/// The precision of a number type. `feasible`, relative to the reach: a point outside a half-space by no more than that
/// counts as inside. `pivot`: the least volume that three unit normals of a basis span. `rounding`: the error of a
/// bound, relative to the reach times 1 + the sum of the multipliers. A bound takes 4 products and 4 sums for each of 3
/// components, and as many for the offsets. With the planes' own rounding, the error is at most 32 times half a unit in
/// the last place.
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

/// 0 if wanted.normal . p >= wanted.offset is proven for all p in the solid. Otherwise the metres > 0 by which the
/// proof falls short. wanted.normal is a unit vector. Takes at most 4 (count + 6) pivots.
template <class Real>
double shortfall(const Solid<Real>& solid, const Plane<Real>& wanted) noexcept;

extern template double shortfall(const Solid<double>&, const Plane<double>&) noexcept;
extern template double shortfall(const Solid<DoubleDouble>&, const Plane<DoubleDouble>&) noexcept;

/// True if it is proven that the solid lies beyond the plane `wanted`.
template <class Real>
bool lies_beyond(const Solid<Real>& solid, const Plane<Real>& wanted) noexcept {
  return !(shortfall(solid, wanted) > 0.0);
}

}  // namespace tern

#endif
