// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vectors of doubles, or of numbers of twice their precision.
#ifndef TERN_BASE_TRIPLE_HPP
#define TERN_BASE_TRIPLE_HPP

namespace tern {

template <class Real>
struct Triple {
  Real x;
  Real y;
  Real z;
};

template <class Real>
Triple<Real> operator+(const Triple<Real>& a, const Triple<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real>
Triple<Real> operator*(const Real& s, const Triple<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class Real>
Real dot(const Triple<Real>& a, const Triple<Real>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <class Real>
Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace tern

#endif
