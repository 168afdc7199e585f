// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_NOISE_HPP
#define TERN_HOST_FLIGHT_NOISE_HPP

#include <cstdint>
#include <random>

namespace tern_host {

/// How far simulated rays and beams are followed, in ranges.
constexpr double kFarther = 1.5;
/// The least depth or distance of an outlier, metres.
constexpr double kNearestOutlier = 0.1;

/// Uniform numbers that are the same on every platform.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : engine_(seed) {}
  double within(double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(engine_() >> 11) * (1.0 / 9007199254740992.0));
  }
  bool chance(double part) { return within(0.0, 1.0) < part; }
  /// One of 0 .. count - 1.
  int below(int count) { return static_cast<int>(within(0.0, count)); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace tern_host

#endif
