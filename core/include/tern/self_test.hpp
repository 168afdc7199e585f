// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Run self_test() before the first flight. It checks that this machine computes as Tern requires, and that your program
// and the library were compiled with the same capacities. docs/determinism.md explains the faults.
#ifndef TERN_SELF_TEST_HPP
#define TERN_SELF_TEST_HPP

#include <stdint.h>

#include "tern/config.hpp"
#include "tern/status.hpp"

namespace tern {

/// FNV-1a over integers, in the order given. This and the next two functions compute the configuration hash. Do not
/// call them: use kConfigurationHash.
constexpr uint64_t hash_of(uint64_t hash) noexcept {
  return hash;
}
template <typename... Rest>
constexpr uint64_t hash_of(uint64_t hash, int64_t value, Rest... rest) noexcept {
  return hash_of((hash ^ static_cast<uint64_t>(value)) * 0x100000001B3u, rest...);
}

/// `constant` * `part` * `of` as an integer. It is exact if the factors are powers of two that leave no fraction. There
/// are two factors because a single one of that size would not fit in 64 bits.
constexpr int64_t whole_of(double constant, int64_t part, int64_t of) noexcept {
  return static_cast<int64_t>(constant * static_cast<double>(part) * static_cast<double>(of));
}

/// The configuration hash that goes with these values of kLatticeTolerance and kSightMargin.
constexpr uint64_t configuration_hash_of(double lattice_tolerance, double sight_margin) noexcept {
  return hash_of(0xCBF29CE484222325u, kMaxCells, kMaxDimension, kMaxNodes, kMaxOpen, kMaxJumpPoints, kMaxSegments,
                 kMaxPlanes, kMaxLocalBoxes, kMaxActive, kMaxQpIterations, kMaxQpSolves, kMaxFences, kMaxFencePlanes,
                 kMaxVias, kMaxTracks, kMaxTrackPieces, kMaxNeighbours, kMaxSeparations, kMaxFloodWords, kMaxWorldWords,
                 kMaxPixels, kMaxPriorBoxes, kMaxYawPieces,
                 whole_of(lattice_tolerance, int64_t{1} << 41, int64_t{1} << 41),
                 whole_of(sight_margin, int64_t{1} << 57, 1));
}

/// A hash of every capacity of config.hpp and of the bits of its two floating-point constants. Two programs have the
/// same hash if they were compiled with the same capacities and no compiler flag changed the constants. Compare it with
/// the library's, or let Planner and self_test() do so.
constexpr uint64_t configuration_hash() noexcept {
  return configuration_hash_of(kLatticeTolerance, kSightMargin);
}

/// configuration_hash() as a constant. Each source file has its own copy, which tells what that file was compiled with.
constexpr uint64_t kConfigurationHash = configuration_hash();

/// What a self-test found wrong: a sum of these bits, or 0 if all is well. A fault that a compiler flag causes is named
/// after the flag; remove that flag. The test finds a flag only if it changes results, and at -O0 some do not.
enum SelfTestFault : uint32_t {
  kFaultFlushToZero = 1u << 0,      ///< denormals are flushed to zero: the program was linked with -ffast-math
  kFaultRoundingMode = 1u << 1,     ///< the thread's rounding mode is not round-to-nearest-even
  kFaultContraction = 1u << 2,      ///< a * b + c was fused: the core was compiled without -ffp-contract=off
  kFaultArithmetic = 1u << 3,       ///< NaN, infinity or sqrt do not behave as IEEE 754 says: -ffinite-math-only
  kFaultConfiguration = 1u << 4,    ///< the caller's headers and the library have different capacities
  kFaultReciprocalMath = 1u << 5,   ///< a / b became a * (1 / b): -freciprocal-math
  kFaultNoSignedZeros = 1u << 6,    ///< -0 and +0 count as the same: -fno-signed-zeros
  kFaultAssociativeMath = 1u << 7,  ///< the order of sums was changed: -fassociative-math
  kFaultSinglePrecisionConstant = 1u << 8,  ///< 0.1 means 0.1f in the core or the caller: -fsingle-precision-constant
};

/// Tests the floating-point arithmetic of the calling thread, and compares `hash`, the caller's kConfigurationHash,
/// with the library's. Run it at start-up in every thread that plans, because each thread has its own floating-point
/// mode.
///
/// kOk, or kSelfTestFailed. `faults` gets the sum of SelfTestFault bits; it may be null.
Status self_test(uint64_t hash, uint32_t* faults) noexcept;

}  // namespace tern

#endif
