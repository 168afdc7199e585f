// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BASE_WORK_HPP
#define TERN_BASE_WORK_HPP

#include <cstdint>

namespace tern {

/// A slice of work: a stage's advance() takes one unit before each piece of work and returns Progress::kMore when none
/// is left. What a unit is, each stage states; no unit is unbounded.
struct Work {
  std::uint32_t left;

  bool take() noexcept {
    if (left == 0) return false;
    --left;
    return true;
  }
};

/// Of two amounts of work.
constexpr std::uint32_t least(std::uint32_t a, std::uint32_t b) noexcept {
  return b < a ? b : a;
}

/// A high-water mark: what is done again does not lower it.
inline void raise(std::int32_t& mark, std::int32_t value) noexcept {
  if (mark < value) mark = value;
}

}  // namespace tern

#endif
