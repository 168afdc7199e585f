// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BASE_WORK_HPP
#define TERN_BASE_WORK_HPP

#include <cstdint>

namespace tern {

/// A slice of work: a stage's advance() takes one unit before each piece of work and returns Progress::kMore when none
/// is left. Each stage says what a unit is; no unit is unbounded.
///
/// Units differ in size. So each piece also adds to `effort` the number of instructions that it took. This is a high
/// estimate from counted quantities, such as sizes and turns of loops, never from time. A flight charges effort, so
/// that its ticks take about the same time whatever they work on.
struct Work {
  std::uint32_t left;        ///< units
  std::uint32_t effort = 0;  ///< instructions of the pieces done; the caller's to reset

  bool take() noexcept {
    if (left == 0) return false;
    --left;
    return true;
  }
};

/// The effort of `count` turns of a loop.
constexpr std::uint32_t effort_of(std::uint32_t each, int count) noexcept {
  return each * static_cast<std::uint32_t>(count);
}

/// The lesser of two amounts of work.
constexpr std::uint32_t least(std::uint32_t a, std::uint32_t b) noexcept {
  return b < a ? b : a;
}

/// Raises a high-water mark to `value`, if that is higher.
inline void raise(std::int32_t& mark, std::int32_t value) noexcept {
  if (mark < value) mark = value;
}

}  // namespace tern

#endif
