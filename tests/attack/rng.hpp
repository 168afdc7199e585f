// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_ATTACK_RNG_HPP
#define TERN_TESTS_ATTACK_RNG_HPP

#include <cmath>
#include <cstdint>

#include "support/random.hpp"

namespace tern_attack {

/// All that a case does follows from one of these.
class Rng : public tern_test::Random {
 public:
  using Random::Random;

  /// Uniform in its logarithm.
  double spread(double lo, double hi) { return std::exp(real(std::log(lo), std::log(hi))); }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
  template <class T, int N>
  const T& pick(const T (&values)[N]) {
    return values[integer(0, N - 1)];
  }
};

/// A stream of its own that does not move `rng` on: what draws from it changes nothing that comes after.
inline Rng side_stream(Rng rng) {
  return Rng(rng.next() ^ 0x7F4A7C159E3779B9u);
}

/// Where case `number` of `seed` begins.
inline Rng rng_of(std::uint64_t seed, std::uint64_t number) {
  Rng mixed(seed * 0xD1342543DE82EF95u + 0x632BE59BD9B4E019u);
  return Rng(mixed.next() ^ (number * 0x9E6C63D0876A9A47u));
}

}  // namespace tern_attack

#endif
