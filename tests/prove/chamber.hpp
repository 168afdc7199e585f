// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A room without anything in it, moves along lines, and the whole proof of one.
#ifndef TERN_TESTS_PROVE_CHAMBER_HPP
#define TERN_TESTS_PROVE_CHAMBER_HPP

#include <gtest/gtest.h>

#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"
#include "support/random.hpp"
#include "tern/fence.hpp"
#include "tern/proof.hpp"

namespace tern_test {

/// From rest to rest along a line, and aside by a bend.
inline tern::Trajectory move(const tern::Vec3& from, const tern::Vec3& by, const tern::Vec3& bend = {0.0, 0.0, 0.0}) {
  tern::Trajectory plan{};
  plan.count = 1;
  plan.origin = from;
  plan.segments[0].duration = 2.0;
  for (int i = 0; i < tern::kControlPoints; ++i) {
    const double part = i < 4 ? 0.0 : 1.0;
    const double aside = i == 3 || i == 4 ? 1.0 : 0.0;
    plan.segments[0].points[i] = {part * by.x + aside * bend.x, part * by.y + aside * bend.y,
                                  part * by.z + aside * bend.z};
  }
  return plan;
}

struct Proven {
  double until;
  tern::Finding finding;
  std::uint32_t work;
};

inline Proven prove(const tern::Grid& grid, const tern::Trajectory& plan, const tern::ProofGrounds& grounds) {
  tern::Proof proof;
  EXPECT_EQ(proof.begin(grid, plan, 0.0, nullptr, tern::Beyond::kSolid, grounds), tern::Status::kRunning);
  while (proof.step(1000) == tern::Status::kRunning) {
  }
  return {proof.report().until, proof.report().finding, proof.report().work};
}

struct Chamber : OwnedGrid {
  Chamber() : OwnedGrid(whole_grid({60, 60, 40}, 0.1, 0.4, {2.0, -3.0, 0.0})) {}
};

}  // namespace tern_test

#endif
