// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The outcome of each test depends on one compiler flag, or one mode of the processor. A constant that is not exact in
// single precision is written as its bits, which no flag can change.
#include "tern/self_test.hpp"

#include <cstdint>

#include "base/math.hpp"

namespace tern {
namespace {

std::uint64_t to_bits(double x) {
  std::uint64_t bits = 0;
  __builtin_memcpy(&bits, &x, sizeof bits);
  return bits;
}

double from_bits(std::uint64_t bits) {
  double x = 0.0;
  __builtin_memcpy(&x, &bits, sizeof x);
  return x;
}

constexpr std::uint64_t kOneBits = 0x3FF0000000000000u;
constexpr std::uint64_t kLeastNormalBits = 0x0010000000000000u;
constexpr std::uint64_t kGreatestBits = 0x7FEFFFFFFFFFFFFFu;
constexpr std::uint64_t kHalfUlpOfOneBits = 0x3CA0000000000000u;  // 2^-53
constexpr std::uint64_t kSquareRootOfTwoBits = 0x3FF6A09E667F3BCDu;
constexpr std::uint64_t kTenthBits = 0x3FB999999999999Au;

/// Hides a value from the compiler, so that each test is computed at run time, in the floating-point mode of the
/// thread.
double opaque(double x) {
  volatile double hidden = x;
  return hidden;
}

bool flushes_to_zero() {
  const double least_normal = opaque(from_bits(kLeastNormalBits));
  const double half = opaque(0.5);
  const double denormal = opaque(least_normal * half);
  return !(denormal > 0.0) || !(opaque(denormal * opaque(2.0)) >= least_normal);
}

bool rounds_to_nearest_even() {
  const double one = opaque(1.0);
  const double tie_down = opaque(from_bits(kHalfUlpOfOneBits));       // the tie goes to the even 1
  const double above_tie = opaque(from_bits(kHalfUlpOfOneBits + 1));  // a little more than the tie rounds up
  const double up = opaque(one + above_tie);
  const bool positive = !(opaque(one + tie_down) > one) && up > one;
  const bool negative = !(opaque(-one - tie_down) < -one) && opaque(-one - above_tie) < -one;
  return positive && negative;
}

/// (1 + e)^2 - (1 + 2e): 0 if the product is rounded first, e^2 if it is fused into the sum.
bool contracts() {
  const double e = 1.0 / 134217728.0;  // 2^-27
  const double a = opaque(1.0 + e);
  const double c = opaque(-(1.0 + 2.0 * e));
  return absolute(a * a + c) > 0.0;
}

bool arithmetic_is_ieee() {
  const double zero = opaque(0.0);
  const double infinity = opaque(1.0) / zero;
  const double nan = opaque(zero / zero);
  const bool specials = infinity > from_bits(kGreatestBits) && !(nan <= 0.0) && !(nan >= 0.0) && !finite(nan);
  const bool roots = to_bits(square_root(opaque(2.0))) == kSquareRootOfTwoBits;
  return specials && roots && !finite(infinity);
}

/// 49 / 49 is 1; 49 times the rounded reciprocal of 49 is the number before 1.
bool multiplies_by_reciprocals() {
  return to_bits(opaque(49.0) / 49.0) != kOneBits;
}

/// -0 + 0 and 0 - 0 are +0. A compiler that ignores the sign of zeros replaces them by the first operand and by the
/// negative of the second: -0.
bool loses_signs_of_zeros() {
  return to_bits(opaque(-0.0) + 0.0) != 0 || to_bits(0.0 - opaque(0.0)) != 0;
}

/// (2^53 + 1) - 2^53 is 0, because the sum is a tie that goes to the even 2^53; in another order it is 1.
bool reorders_sums() {
  const double large = opaque(9007199254740992.0);
  const double one = opaque(1.0);
  return (large + one) - large > 0.0;
}

bool shortens_constants() {
  return to_bits(0.1) != kTenthBits;
}

/// Tests the caller's configuration hash. A flag of the caller that shortens constants changes the hash.
std::uint32_t faults_of_hash(std::uint64_t hash) {
  if (hash == configuration_hash()) return 0;
  const double tolerance = static_cast<double>(static_cast<float>(kLatticeTolerance));
  const double margin = static_cast<double>(static_cast<float>(kSightMargin));
  return hash == configuration_hash_of(tolerance, margin) ? kFaultSinglePrecisionConstant : kFaultConfiguration;
}

}  // namespace

Status self_test(std::uint64_t hash, std::uint32_t* faults) noexcept {
  std::uint32_t found = faults_of_hash(hash);
  if (flushes_to_zero()) found |= kFaultFlushToZero;
  if (!rounds_to_nearest_even()) found |= kFaultRoundingMode;
  if (contracts()) found |= kFaultContraction;
  if (!arithmetic_is_ieee()) found |= kFaultArithmetic;
  if (multiplies_by_reciprocals()) found |= kFaultReciprocalMath;
  if (loses_signs_of_zeros()) found |= kFaultNoSignedZeros;
  if (reorders_sums()) found |= kFaultAssociativeMath;
  if (shortens_constants()) found |= kFaultSinglePrecisionConstant;
  if (faults != nullptr) *faults = found;
  return found == 0 ? Status::kOk : Status::kSelfTestFailed;
}

}  // namespace tern
