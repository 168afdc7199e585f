// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_CAPACITY_CASES_ASKED_HPP
#define TERN_TESTS_CAPACITY_CASES_ASKED_HPP

#include <cstdlib>

#include "support/random.hpp"

namespace tern_capacity {

/// How many cases to run: `full`, scaled as in all tests, and so many times over as tools/capacities asks for.
inline int cases(int full) {
  const char* times = std::getenv("TERN_CAPACITY_TIMES");
  return tern_test::scaled(full) * (times == nullptr ? 1 : std::atoi(times));
}

}  // namespace tern_capacity

#endif
