// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The test for a capacity or a budget that is used up. The core always asks is_full(), so that a test can make any one
// of these calls return true: the tiny library of the tests has its own is_full() (tests/capacity). In every other
// build, is_full(x) is x.
#ifndef TERN_BASE_CAPACITY_HPP
#define TERN_BASE_CAPACITY_HPP

namespace tern {

#ifdef TERN_CAPACITY_TEST
bool is_full(bool full, const char* file = __builtin_FILE(), int line = __builtin_LINE()) noexcept;
#else
constexpr bool is_full(bool full) noexcept {
  return full;
}
#endif

}  // namespace tern

#endif
