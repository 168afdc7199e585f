// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vectors and matrices of fixed size. Eigen computes sums, differences, multiples and blocks, because there is only one
// order to compute them in. Scalar products, lengths and products of matrices are written here, because Eigen does not
// promise the order of their sums.
#ifndef TERN_BASE_LINEAR_HPP
#define TERN_BASE_LINEAR_HPP

#include <Eigen/Core>

#include "base/math.hpp"

namespace tern {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
using Vector2 = Eigen::Vector2d;

// One line an operation.
// clang-format off
inline Vector to_vector(const Vec3& v) { return Vector(v.x, v.y, v.z); }
inline Vec3 to_vec3(const Vector& v) { return Vec3{v[0], v[1], v[2]}; }

/// Three neighbours in an array of doubles, as a vector.
inline Eigen::Map<Vector> vector_at(double* p) { return Eigen::Map<Vector>(p); }
inline Eigen::Map<const Vector> vector_at(const double* p) { return Eigen::Map<const Vector>(p); }

/// An array of three rows, as a matrix.
using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
inline Eigen::Map<Rows> matrix_of(double (&rows)[3][3]) { return Eigen::Map<Rows>(rows[0]); }

inline double dot(const Vector& a, const Vector& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }
inline double length(const Vector& a) { return square_root(dot(a, a)); }
// clang-format on

inline Vector cross(const Vector& a, const Vector& b) {
  return Vector(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

inline Vector multiply(const Matrix& m, const Vector& v) {
  return (m.col(0) * v[0] + m.col(1) * v[1]) + m.col(2) * v[2];
}

/// v v', which is symmetric to the bit.
inline Matrix outer(const Vector& v) {
  Matrix product;
  for (int k = 0; k < 3; ++k) product.col(k) = v * v[k];
  return product;
}

}  // namespace tern

#endif
