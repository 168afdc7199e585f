// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_PROVEN_CLEAR_HPP
#define TERN_TESTS_SUPPORT_PROVEN_CLEAR_HPP

#include "check/check_stage.hpp"

namespace tern_test {

/// What the check says of a polyhedron, whatever it finds.
inline bool proven_clear(const tern::Grid& grid, const tern::Polyhedron& polyhedron) {
  tern::CheckReport found;
  return polyhedron_clear(grid, polyhedron, found);
}

}  // namespace tern_test

#endif
