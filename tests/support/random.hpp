// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_RANDOM_HPP
#define TERN_TESTS_SUPPORT_RANDOM_HPP

#include <cstdint>

namespace tern_test {

/// SplitMix64: the same numbers on every platform, which <random>'s distributions do not promise.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

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
  bool chance(double p) { return unit() < p; }

 private:
  std::uint64_t state_;
};

/// `full` cases on a host, the configured part of them elsewhere, one at least.
inline int scaled(int full) {
  const int n = static_cast<int>(full * (TERN_TEST_SCALE));
  return n < 1 ? 1 : n;
}

}  // namespace tern_test

#endif
