// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two doubles side by side, as in one register of SSE2 and NEON. With these, a sum over a long vector is fast and still
// has one order, the same with every compiler and at every optimisation level.
#ifndef TERN_QP_LANES_HPP
#define TERN_QP_LANES_HPP

#include "base/vectors.hpp"

namespace tern::qp {

/// A pair for targets without such registers. Its numbers are copied one by one, because compilers copy whole
/// structures through memory. Its functions are always inlined, also in images that are compiled for size.
struct __attribute__((__may_alias__)) PlainPair {
  double first, second;

  PlainPair() = default;
  [[gnu::always_inline]] PlainPair(double a, double b) : first(a), second(b) {}
  [[gnu::always_inline]] PlainPair(const PlainPair& other) : first(other.first), second(other.second) {}
  [[gnu::always_inline]] PlainPair& operator=(const PlainPair& other) {
    first = other.first;
    second = other.second;
    return *this;
  }
  [[gnu::always_inline]] double operator[](int k) const { return k == 0 ? first : second; }
  [[gnu::always_inline]] double& operator[](int k) { return k == 0 ? first : second; }
};
[[gnu::always_inline]] inline PlainPair operator+(const PlainPair& a, const PlainPair& b) {
  return {a.first + b.first, a.second + b.second};
}
[[gnu::always_inline]] inline PlainPair operator-(const PlainPair& a, const PlainPair& b) {
  return {a.first - b.first, a.second - b.second};
}
[[gnu::always_inline]] inline PlainPair operator-(const PlainPair& a) {
  return {-a.first, -a.second};
}
[[gnu::always_inline]] inline PlainPair operator*(const PlainPair& a, const PlainPair& b) {
  return {a.first * b.first, a.second * b.second};
}
[[gnu::always_inline]] inline PlainPair& operator+=(PlainPair& a, const PlainPair& b) {
  return a = a + b;
}
[[gnu::always_inline]] inline PlainPair& operator-=(PlainPair& a, const PlainPair& b) {
  return a = a - b;
}
[[gnu::always_inline]] inline PlainPair& operator*=(PlainPair& a, const PlainPair& b) {
  return a = a * b;
}
[[gnu::always_inline]] inline PlainPair larger_of(const PlainPair& a, const PlainPair& b) {
  return {a.first > b.first ? a.first : b.first, a.second > b.second ? a.second : b.second};
}

using VectorPair __attribute__((vector_size(16), __may_alias__)) = double;
inline VectorPair larger_of(VectorPair a, VectorPair b) {
  return a > b ? a : b;
}

/// Stores two neighbours anywhere in an array of doubles.
[[gnu::always_inline]] inline void store_two(const PlainPair& value, double* p) {
  p[0] = value.first;
  p[1] = value.second;
}
inline void store_two(VectorPair value, double* p) {
  __builtin_memcpy(p, &value, sizeof value);
}

#if TERN_HAS_VECTORS
using Pair = VectorPair;
#else
using Pair = PlainPair;
#endif
constexpr bool kVectors = TERN_HAS_VECTORS;

constexpr int kPair = 2;
/// Vectors are padded with zeros to a multiple of this, so that kernels need no tails.
constexpr int kPad = 4;

constexpr int padded(int n) {
  return (n + kPad - 1) / kPad * kPad;
}

/// The pair at `p`, which must be 16-byte aligned.
inline const Pair& pair(const double* p) {
  return *reinterpret_cast<const Pair*>(p);
}
inline Pair& pair(double* p) {
  return *reinterpret_cast<Pair*>(p);
}
/// Loads two neighbours from anywhere in an array of doubles.
inline Pair load_two(const double* p) {
#if TERN_HAS_VECTORS
  Pair value;
  __builtin_memcpy(&value, p, sizeof value);
  return value;
#else
  return {p[0], p[1]};
#endif
}
inline Pair both(double v) {
  return Pair{v, v};
}
/// The pair at `p` where both doubles are the same: without vectors, only one is read.
inline Pair twice(const double* p) {
  return kVectors ? pair(p) : both(*p);
}
inline double sum(Pair a) {
  return a[0] + a[1];
}

/// Sum of a_i b_i over [begin, end), both multiples of kPad.
inline double inner(const double* a, const double* b, int begin, int end) {
  Pair even = both(0.0);
  Pair odd = both(0.0);
  for (int i = begin; i < end; i += kPad) {
    even += pair(a + i) * pair(b + i);
    odd += pair(a + i + kPair) * pair(b + i + kPair);
  }
  return sum(even + odd);
}

/// y += s * x over [begin, end).
inline void add_scaled(double s, const double* x, double* y, int begin, int end) {
  const Pair factor = both(s);
  for (int i = begin; i < end; i += kPair) pair(y + i) += factor * pair(x + i);
}

}  // namespace tern::qp

#endif
