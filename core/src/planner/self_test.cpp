// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/self_test.hpp"

#include <cstdint>

#include "base/math.hpp"

namespace tern {
namespace {

/// A value that the compiler cannot see through: each test runs on the machine, in the thread's own mode.
double opaque(double x) {
  volatile double hidden = x;
  return hidden;
}

bool flushes_to_zero() {
  const double least_normal = opaque(2.2250738585072014e-308);
  const double half = opaque(0.5);
  const double denormal = opaque(least_normal * half);
  return !(denormal > 0.0) || !(opaque(denormal * opaque(2.0)) >= least_normal);
}

bool rounds_to_nearest_even() {
  const double one = opaque(1.0);
  const double tie_down = opaque(1.1102230246251565e-16);   // half an ulp of 1: the tie goes to the even 1
  const double above_tie = opaque(1.1102230246251568e-16);  // a little more: up
  const double up = opaque(one + above_tie);
  const bool positive = !(opaque(one + tie_down) > one) && up > one;
  const bool negative = !(opaque(-one - tie_down) < -one) && opaque(-one - above_tie) < -one;
  return positive && negative;
}

/// (1 + e)^2 - (1 + 2e): 0 where the product is rounded first, e^2 where it is fused into the sum.
bool contracts() {
  const double e = 7.450580596923828e-9;  // 2^-27
  const double a = opaque(1.0 + e);
  const double c = opaque(-(1.0 + 2.0 * e));
  return absolute(a * a + c) > 0.0;
}

bool arithmetic_is_ieee() {
  const double zero = opaque(0.0);
  const double infinity = opaque(1.0) / zero;
  const double nan = opaque(zero / zero);
  const bool specials = infinity > 1.7976931348623157e308 && !(nan <= 0.0) && !(nan >= 0.0) && !finite(nan);
  const double root = square_root(opaque(2.0));
  const bool roots = root >= 1.4142135623730951 && root <= 1.4142135623730951;
  return specials && roots && !finite(infinity);
}

}  // namespace

Status self_test(std::uint64_t hash, std::uint32_t* faults) noexcept {
  std::uint32_t found = 0;
  if (flushes_to_zero()) found |= kFaultFlushToZero;
  if (!rounds_to_nearest_even()) found |= kFaultRoundingMode;
  if (contracts()) found |= kFaultContraction;
  if (!arithmetic_is_ieee()) found |= kFaultArithmetic;
  if (hash != configuration_hash()) found |= kFaultConfiguration;
  if (faults != nullptr) *faults = found;
  return found == 0 ? Status::kOk : Status::kSelfTestFailed;
}

}  // namespace tern
