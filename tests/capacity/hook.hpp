// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Each question of the core whether a capacity or a budget is used up (base/capacity.hpp) comes here in the tiny
// library: it is counted, and one of them can be answered with yes although there is room.
#ifndef TERN_TESTS_CAPACITY_HOOK_HPP
#define TERN_TESTS_CAPACITY_HOOK_HPP

#include <cstdint>

namespace tern_capacity {

/// A place in the core's sources that asks.
struct Site {
  const char* file;
  int line;
  std::uint64_t asked;  ///< times since begin()
  std::uint64_t first;  ///< the number of its first and of its last question
  std::uint64_t last;
};

constexpr int kMostSites = 128;

enum class Failing {
  kOnce,     ///< one question alone
  kForGood,  ///< that question, and all that its place asks from then on, as a capacity that is full would
};

/// Begins to count from 0, and answers the question number `failing` (from 1 on) with yes; 0: none.
void begin(std::uint64_t failing = 0, Failing how = Failing::kOnce) noexcept;
/// From here on, all questions are answered as they are, and none is counted.
void end() noexcept;
/// Questions from begin() to end().
std::uint64_t asked() noexcept;
/// Places that have asked since the program began.
int site_count() noexcept;
Site site(int index) noexcept;
/// The place whose question was answered with yes since begin(); its file is null where there was none.
Site failed_site() noexcept;

}  // namespace tern_capacity

#endif
