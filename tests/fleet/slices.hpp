// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ticks of a fleet that do as little as they can.
#ifndef TERN_TESTS_FLEET_SLICES_HPP
#define TERN_TESTS_FLEET_SLICES_HPP

#include <cstdint>

#include "tern/fleet.hpp"

namespace tern_test {

/// Operations that a tick takes whatever it is given: it decides, and looks who is a member. None are left for proofs.
inline std::int64_t advance_without_proofs(tern::Fleet& fleet, std::int64_t now) {
  tern::Work none;
  fleet.advance(now, none);
  return -none.operations();
}

/// One piece of a proof, if one is to be done.
inline void advance_a_piece(tern::Fleet& fleet, std::int64_t now) {
  const std::int64_t always = advance_without_proofs(fleet, now);
  tern::Work piece = tern::Work(1'000'000).within(always + 1);
  fleet.advance(now, piece);
}

}  // namespace tern_test

#endif
