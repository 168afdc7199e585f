// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two doubles side by side, as in one register of SSE2 and NEON. With these, a sum over a long vector is fast and still
// has one order, the same with every compiler and at every optimisation level.
#ifndef TERN_QP_LANES_HPP
#define TERN_QP_LANES_HPP

namespace tern::qp {

using Pair __attribute__((vector_size(16), __may_alias__)) = double;

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
  Pair value;
  __builtin_memcpy(&value, p, sizeof value);
  return value;
}
inline void store_two(Pair value, double* p) {
  __builtin_memcpy(p, &value, sizeof value);
}
inline Pair both(double v) {
  return Pair{v, v};
}
inline Pair larger_of(Pair a, Pair b) {
  return a > b ? a : b;
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
