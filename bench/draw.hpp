// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_DRAW_HPP
#define TERN_BENCH_DRAW_HPP

#include <cstdint>
#include <random>

namespace tern_bench {

/// Engines of <random> give the same numbers everywhere; its distributions do not.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  /// Uniform in [low, high], but for the bias of a remainder.
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace tern_bench

#endif
