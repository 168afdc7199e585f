// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Four numbers at a time, which fit a register of SSE2 or NEON.
#ifndef TERN_VIEW_FOUR_HPP
#define TERN_VIEW_FOUR_HPP

#include <cstdint>

#include "base/vectors.hpp"

namespace tern {

/// Four numbers for targets without such registers. They are copied one by one, because compilers copy whole structures
/// through memory. A comparison answers -1 or 0.
template <typename T>
struct PlainFour {
  using Mask = PlainFour<std::int32_t>;

  PlainFour() = default;
  PlainFour(T x) noexcept : lanes{x, x, x, x} {}
  PlainFour(T a, T b, T c, T d) noexcept : lanes{a, b, c, d} {}
  PlainFour(const PlainFour& x) noexcept : lanes{x[0], x[1], x[2], x[3]} {}
  // It may copy from itself. NOLINTNEXTLINE(bugprone-unhandled-self-assignment)
  PlainFour& operator=(const PlainFour& x) noexcept {
    for (int k = 0; k < 4; ++k) lanes[k] = x.lanes[k];
    return *this;
  }
  T operator[](int k) const noexcept { return lanes[k]; }
  T& operator[](int k) noexcept { return lanes[k]; }

  template <typename Result, typename Of>
  static PlainFour<Result> each(const PlainFour& x, const PlainFour& y, Of of) noexcept {
    return {of(x[0], y[0]), of(x[1], y[1]), of(x[2], y[2]), of(x[3], y[3])};
  }
  friend PlainFour operator+(const PlainFour& x, const PlainFour& y) noexcept {
    return each<T>(x, y, [](T a, T b) { return a + b; });
  }
  friend PlainFour operator-(const PlainFour& x, const PlainFour& y) noexcept {
    return each<T>(x, y, [](T a, T b) { return a - b; });
  }
  friend PlainFour operator*(const PlainFour& x, const PlainFour& y) noexcept {
    return each<T>(x, y, [](T a, T b) { return a * b; });
  }
  friend PlainFour operator/(const PlainFour& x, const PlainFour& y) noexcept {
    return each<T>(x, y, [](T a, T b) { return a / b; });
  }
  friend PlainFour operator&(const PlainFour& x, const PlainFour& y) noexcept {
    return each<T>(x, y, [](T a, T b) { return a & b; });
  }
  friend PlainFour operator|(const PlainFour& x, const PlainFour& y) noexcept {
    return each<T>(x, y, [](T a, T b) { return a | b; });
  }
  friend PlainFour operator>>(const PlainFour& x, int bits) noexcept {
    return {x[0] >> bits, x[1] >> bits, x[2] >> bits, x[3] >> bits};
  }
  friend Mask operator<(const PlainFour& x, const PlainFour& y) noexcept {
    return each<std::int32_t>(x, y, [](T a, T b) { return a < b ? -1 : 0; });
  }
  friend Mask operator<=(const PlainFour& x, const PlainFour& y) noexcept {
    return each<std::int32_t>(x, y, [](T a, T b) { return a <= b ? -1 : 0; });
  }
  friend Mask operator>(const PlainFour& x, const PlainFour& y) noexcept { return y < x; }
  friend Mask operator>=(const PlainFour& x, const PlainFour& y) noexcept { return y <= x; }
  friend PlainFour& operator+=(PlainFour& x, const PlainFour& y) noexcept { return x = x + y; }
  friend PlainFour& operator&=(PlainFour& x, const PlainFour& y) noexcept { return x = x & y; }

  T lanes[4];
};

/// x where a comparison holds, else y.
template <typename T>
PlainFour<T> choose(const PlainFour<std::int32_t>& holds, const PlainFour<T>& x, const PlainFour<T>& y) noexcept {
  return {holds[0] != 0 ? x[0] : y[0], holds[1] != 0 ? x[1] : y[1], holds[2] != 0 ? x[2] : y[2],
          holds[3] != 0 ? x[3] : y[3]};
}
inline PlainFour<float> absolute(const PlainFour<float>& x) noexcept {
  return {__builtin_fabsf(x[0]), __builtin_fabsf(x[1]), __builtin_fabsf(x[2]), __builtin_fabsf(x[3])};
}
/// Whole numbers, rounded towards 0.
inline PlainFour<std::int32_t> whole(const PlainFour<float>& x) noexcept {
  const auto one = [](float number) { return static_cast<std::int32_t>(number); };
  return {one(x[0]), one(x[1]), one(x[2]), one(x[3])};
}
inline PlainFour<float> decimal(const PlainFour<std::int32_t>& x) noexcept {
  const auto one = [](std::int32_t number) { return static_cast<float>(number); };
  return {one(x[0]), one(x[1]), one(x[2]), one(x[3])};
}

using VectorFour __attribute__((vector_size(16), __may_alias__)) = float;
using VectorFourInts __attribute__((vector_size(16), __may_alias__)) = std::int32_t;

inline VectorFour choose(VectorFourInts holds, VectorFour x, VectorFour y) noexcept {
  return holds ? x : y;
}
inline VectorFourInts choose(VectorFourInts holds, VectorFourInts x, VectorFourInts y) noexcept {
  return holds ? x : y;
}
inline VectorFour absolute(VectorFour x) noexcept {
  return reinterpret_cast<VectorFour>(reinterpret_cast<VectorFourInts>(x) & 0x7fffffff);
}
inline VectorFourInts whole(VectorFour x) noexcept {
  return __builtin_convertvector(x, VectorFourInts);
}
inline VectorFour decimal(VectorFourInts x) noexcept {
  return __builtin_convertvector(x, VectorFour);
}

#if TERN_HAS_VECTORS
using Four = VectorFour;
using FourInts = VectorFourInts;
#else
using Four = PlainFour<float>;
using FourInts = PlainFour<std::int32_t>;
#endif

inline Four all(float x) noexcept {
  return Four{x, x, x, x};
}
/// The larger one of each two numbers; y where one is NaN.
inline Four larger(const Four& x, const Four& y) noexcept {
#if defined(__SSE2__) && defined(__GNUC__) && !defined(__clang__)
  return __builtin_ia32_maxps(x, y);  // GCC makes four instructions of the choice
#else
  return choose(x > y, x, y);
#endif
}
/// The smaller one of each two numbers; y where one is NaN.
inline Four smaller(const Four& x, const Four& y) noexcept {
#if defined(__SSE2__) && defined(__GNUC__) && !defined(__clang__)
  return __builtin_ia32_minps(x, y);
#else
  return choose(x < y, x, y);
#endif
}
/// Limits each number to low .. high; NaN becomes `low`.
inline Four clamp(const Four& x, float low, float high) noexcept {
  return smaller(larger(x, all(low)), all(high));
}
/// The largest whole numbers <= x, limited to -1 .. count.
inline FourInts floor_index(const Four& x, float count) noexcept {
  return whole(clamp(x, -1.0f, count) + 1.0f) - 1;
}
/// True if any of the numbers is not 0.
inline bool any(const FourInts& x) noexcept {
  return (x[0] | x[1] | x[2] | x[3]) != 0;
}
inline Four square_root(Four x) noexcept {
  for (int k = 0; k < 4; ++k) x[k] = __builtin_sqrtf(x[k]);
  return x;
}

}  // namespace tern

#endif
