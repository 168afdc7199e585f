// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Four numbers in single precision at a time, which fit a register of SSE2 or NEON.
#ifndef TERN_VIEW_FOUR_HPP
#define TERN_VIEW_FOUR_HPP

#include <cstdint>

namespace tern {

using Four __attribute__((vector_size(16), __may_alias__)) = float;
using FourInts __attribute__((vector_size(16), __may_alias__)) = std::int32_t;

inline Four all(float x) noexcept {
  return Four{x, x, x, x};
}
/// Limits each number to low .. high; NaN becomes `low`.
inline Four clamp(Four x, float low, float high) noexcept {
  const Four above = x > low ? x : all(low);
  return above < high ? above : all(high);
}
/// Whole numbers, rounded towards 0.
inline FourInts whole(Four x) noexcept {
  return __builtin_convertvector(x, FourInts);
}
inline Four decimal(FourInts x) noexcept {
  return __builtin_convertvector(x, Four);
}
/// The largest whole numbers <= x, limited to -1 .. count.
inline FourInts floor_index(Four x, float count) noexcept {
  return whole(clamp(x, -1.0f, count) + 1.0f) - 1;
}
/// True if any of the numbers is not 0.
inline bool any(FourInts x) noexcept {
  return (x[0] | x[1] | x[2] | x[3]) != 0;
}
inline Four absolute(Four x) noexcept {
  return x < 0.0f ? -x : x;
}
inline Four square_root(Four x) noexcept {
  for (int k = 0; k < 4; ++k) x[k] = __builtin_sqrtf(x[k]);
  return x;
}

}  // namespace tern

#endif
