// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a capacity or a budget is used up. The core asks is_full() each time, so that a test can let any one of these
// questions be answered with yes: the tiny library of the tests brings a function of its own (tests/capacity). In every
// other build, is_full(x) is x.
#ifndef TERN_BASE_CAPACITY_HPP
#define TERN_BASE_CAPACITY_HPP

namespace tern {

#ifdef TERN_CAPACITY_TEST
bool is_full(bool full, const char* file = __builtin_FILE(), int line = __builtin_LINE()) noexcept;
#else
/// True if `full`.
constexpr bool is_full(bool full) noexcept {
  return full;
}
#endif

}  // namespace tern

#endif
