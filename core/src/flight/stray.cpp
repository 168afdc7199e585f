// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/stray.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// For each MarginUse: the part of the margin at which it begins, and the part of the speed that it leaves.
constexpr double kBegins[] = {0.0, 0.6, 0.8, 1.0};
constexpr double kSpeed[] = {1.0, 0.5, 0.25, 0.25};
/// An error is small up to this part of what `use` begins at.
constexpr double kSmall = 0.5;
/// After so long with small errors alone, the vehicle flies faster again. Gusts come back after seconds. Nanoseconds.
constexpr std::int64_t kCalm = 3000000000;

MarginUse use_of(double error, double margin) {
  if (error > kBegins[3] * margin) return MarginUse::kAll;
  if (error > kBegins[2] * margin) return MarginUse::kMost;
  return error > kBegins[1] * margin ? MarginUse::kMuch : MarginUse::kLittle;
}

}  // namespace

bool Stray::note(double measured, double margin, std::int64_t time) noexcept {
  const double before = speed_share();
  const MarginUse now = margin > 0.0 ? use_of(measured, margin) : MarginUse::kLittle;
  error = measured;
  if (now > use) use = now;
  const bool is_small = measured <= kSmall * kBegins[static_cast<int>(use)] * margin;
  if (!is_small) large = time;
  if (use != MarginUse::kLittle && time - large > kCalm) {
    use = static_cast<MarginUse>(static_cast<int>(use) - 1);
    large = time;
  }
  const bool is_slower = speed_share() < before;
  is_too_fast = is_too_fast || is_slower;
  return is_slower;
}

double Stray::speed_share() const noexcept {
  return kSpeed[static_cast<int>(use)];
}

Limits Stray::limits(const Limits& full) const noexcept {
  Limits left = full;
  if (use == MarginUse::kLittle) return left;
  const double share = speed_share();
  for (int a = 0; a < 3; ++a) {
    axis(left.v_max, a) = larger(kMinLimit, share * axis(full.v_max, a));
    if (axis(full.v_min, a) < 0.0) axis(left.v_min, a) = smaller(-kMinLimit, share * axis(full.v_min, a));
  }
  if (full.v_horizontal > 0.0) left.v_horizontal = larger(kMinLimit, share * full.v_horizontal);
  return left;
}

FlightReason Stray::reason() const noexcept {
  if (use == MarginUse::kAll) return FlightReason::kMarginExceeded;
  return use == MarginUse::kLittle ? FlightReason::kNone : FlightReason::kStrays;
}

}  // namespace tern
