// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences for a while, at random, and whether a plan respects them.
#ifndef TERN_TESTS_ATTACK_WINDOWS_HPP
#define TERN_TESTS_ATTACK_WINDOWS_HPP

#include <list>
#include <vector>

#include "attack/asking.hpp"

namespace tern_attack {

/// Fences for a while, behind those of a request.
struct TimedFences {
  std::vector<tern::Fence> fences;
  std::list<std::vector<tern::Halfspace>> planes;

  /// Adds up to three, as far as there is room. The request then points here.
  void add(Rng& rng, const World& world, tern::Request& request);
};

/// Reports where the plan breaks a fence for a while before `until`, s since its beginning.
void check_windows(const World& world, const tern::Request& request, const tern::Trajectory& plan, double until,
                   const char* what, Findings& findings);

}  // namespace tern_attack

#endif
