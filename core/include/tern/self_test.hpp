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

/// A hash of every capacity and of the ABI number: equal exactly where the headers were compiled with the same
/// configuration.
constexpr uint64_t configuration_hash() noexcept {
  return hash_of(0xCBF29CE484222325u, kMaxCells, kMaxDimension, kMaxNodes, kMaxHeap, kMaxJumpPoints, kMaxSegments,
                 kMaxPlanes, kMaxLocalBoxes, kMaxActive, kMaxQpIterations, kMaxQpSolves, kMaxFences, kMaxFencePlanes,
                 kMaxFenceWords);
}

/// What a self-test found wrong, one bit each; 0 is healthy.
enum SelfTestFault : uint32_t {
  kFaultFlushToZero = 1u << 0,    ///< denormals are flushed: some part of the program was linked with -ffast-math
  kFaultRoundingMode = 1u << 1,   ///< not round-to-nearest-even
  kFaultContraction = 1u << 2,    ///< a * b + c was fused: the core was compiled without -ffp-contract=off
  kFaultArithmetic = 1u << 3,     ///< NaN, infinity or sqrt do not behave as IEEE 754 says
  kFaultConfiguration = 1u << 4,  ///< the caller's headers and the library have different capacities
};

/// Run once at start-up, and again in any thread that plans: the floating-point mode belongs to the thread.
/// `hash` is the caller's configuration_hash(). kOk or kSelfTestFailed, with the faults in *faults where given.
Status self_test(uint64_t hash, uint32_t* faults) noexcept;

}  // namespace tern

#endif
