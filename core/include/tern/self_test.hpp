// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_SELF_TEST_HPP
#define TERN_SELF_TEST_HPP

#include <stdint.h>

#include "tern/config.hpp"
#include "tern/status.hpp"

namespace tern {

/// FNV-1a over whole numbers, in the order given.
constexpr uint64_t hash_of(uint64_t hash) noexcept {
  return hash;
}
template <typename... Rest>
constexpr uint64_t hash_of(uint64_t hash, int64_t value, Rest... rest) noexcept {
  return hash_of((hash ^ static_cast<uint64_t>(value)) * 0x100000001B3u, rest...);
}

/// A constant as a whole number, exact: `part` is a power of two that leaves no fraction. Two factors, because one
/// would be beyond 64 bits.
constexpr int64_t whole_of(double constant, int64_t part, int64_t of) noexcept {
  return static_cast<int64_t>(constant * static_cast<double>(part) * static_cast<double>(of));
}

/// The configuration hash where these are the values of the header's constants.
constexpr uint64_t configuration_hash_of(double lattice_tolerance, double sight_margin) noexcept {
  return hash_of(0xCBF29CE484222325u, kMaxCells, kMaxDimension, kMaxNodes, kMaxOpen, kMaxJumpPoints, kMaxSegments,
                 kMaxPlanes, kMaxLocalBoxes, kMaxActive, kMaxQpIterations, kMaxQpSolves, kMaxFences, kMaxFencePlanes,
                 kMaxFenceWords, whole_of(lattice_tolerance, int64_t{1} << 41, int64_t{1} << 41),
                 whole_of(sight_margin, int64_t{1} << 57, 1));
}

/// A hash of every capacity of config.hpp and of its two floating-point constants, bit for bit: equal exactly where the
/// headers were compiled with the same configuration, and with flags that leave constants alone.
constexpr uint64_t configuration_hash() noexcept {
  return configuration_hash_of(kLatticeTolerance, kSightMargin);
}

/// The same as a constant: each file that includes this has its own, whatever the others were compiled with.
constexpr uint64_t kConfigurationHash = configuration_hash();

/// What a self-test found wrong, one bit each; 0 is healthy. Where a compiler flag does it, the fault is named after
/// the flag to remove. A flag counts where it changes results: at -O0 some do not.
enum SelfTestFault : uint32_t {
  kFaultFlushToZero = 1u << 0,      ///< denormals are flushed: some part of the program was linked with -ffast-math
  kFaultRoundingMode = 1u << 1,     ///< not round-to-nearest-even
  kFaultContraction = 1u << 2,      ///< a * b + c was fused: the core was compiled without -ffp-contract=off
  kFaultArithmetic = 1u << 3,       ///< NaN, infinity or sqrt do not behave as IEEE 754 says: -ffinite-math-only
  kFaultConfiguration = 1u << 4,    ///< the caller's headers and the library have different capacities
  kFaultReciprocalMath = 1u << 5,   ///< a / b became a * (1 / b): the core was compiled with -freciprocal-math
  kFaultNoSignedZeros = 1u << 6,    ///< -0 and +0 are taken for one: likewise, -fno-signed-zeros
  kFaultAssociativeMath = 1u << 7,  ///< sums change their order: likewise, -fassociative-math
  kFaultSinglePrecisionConstant = 1u << 8,  ///< 0.1 is 0.1f in the core or its caller: -fsingle-precision-constant
};

/// Run once at start-up, and again in any thread that plans: the floating-point mode belongs to the thread.
/// `hash` is the caller's configuration_hash(). kOk or kSelfTestFailed, with the faults in *faults where given.
Status self_test(uint64_t hash, uint32_t* faults) noexcept;

}  // namespace tern

#endif
