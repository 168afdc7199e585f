// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid/stencil.hpp"

#include "base/math.hpp"
#include "grid/distance.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

static_assert(kMaxDimension <= 32767, "a reach is 16 bits, and its square 31");

/// Exact, because the root of an integer below 2^31 is correctly rounded, and the root of a non-square is far from an
/// integer.
std::int32_t floor_root(std::int32_t square) {
  return static_cast<std::int32_t>(square_root(static_cast<double>(square)));
}

/// The largest squared gap, in cells squared, that blocks; -1 if not even a gap of 0 does.
std::int32_t largest_blocking_gap(const GridSpec& spec) {
  if (spec.clearance() <= kClearTolerance) return -1;
  const double cells = spec.clearance() / spec.cell;
  // A gap that differs from the radius only by rounding keeps the radius, so it does not block.
  return ceil_index(cells * cells * (1.0 - 2.0 * kLatticeTolerance), 1, kMaxDimension * kMaxDimension) - 1;
}

std::int32_t least(std::int32_t a, std::int32_t b) {
  return b < a ? b : a;
}

}  // namespace

Stencil::Stencil(const GridSpec& spec) : limit_(largest_blocking_gap(spec)), last_row_(spec.dims.y - 1) {
  const std::int32_t gap = limit_ < 0 ? -1 : floor_root(limit_);
  gap_x_ = least(gap, spec.dims.x);
  gap_z_ = least(gap, spec.dims.z);
  for (std::int32_t z = 0; z <= gap_z_ && z < kTable; ++z) {
    for (std::int32_t x = 0; x <= gap_x_ && x < kTable; ++x) table_[z][x] = static_cast<std::int16_t>(compute(z, x));
  }
}

std::int32_t Stencil::compute(std::int32_t gap_z, std::int32_t gap_x) const {
  const std::int32_t rest = limit_ - gap_z * gap_z - gap_x * gap_x;
  return rest < 0 ? -1 : least(floor_root(rest) + 1, last_row_);
}

}  // namespace tern
