// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_ATTACK_RNG_HPP
#define TERN_TESTS_ATTACK_RNG_HPP

#include <cmath>
#include <cstdint>

namespace tern_attack {

/// SplitMix64: the same numbers on every platform. All that a case does follows from one of these.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// Uniform integer in [lo, hi].
  int integer(int lo, int hi) {
    return lo + static_cast<int>(next() % static_cast<std::uint64_t>(static_cast<std::int64_t>(hi) - lo + 1));
  }
  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * (1.0 / 9007199254740992.0); }
  double real(double lo, double hi) { return lo + (hi - lo) * unit(); }
  /// Uniform in its logarithm.
  double spread(double lo, double hi) { return std::exp(real(std::log(lo), std::log(hi))); }
  bool chance(double p) { return unit() < p; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
  template <class T, int N>
  const T& pick(const T (&values)[N]) {
    return values[integer(0, N - 1)];
  }

 private:
  std::uint64_t state_;
};

/// Where case `number` of `seed` begins.
inline Rng rng_of(std::uint64_t seed, std::uint64_t number) {
  Rng mixed(seed * 0xD1342543DE82EF95u + 0x632BE59BD9B4E019u);
  return Rng(mixed.next() ^ (number * 0x9E6C63D0876A9A47u));
}

}  // namespace tern_attack

#endif
