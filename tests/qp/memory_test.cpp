// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a solve of 16 segments takes. Only sizes are looked at here, so that this file may set capacities of its own.
#undef TERN_MAX_SEGMENTS
#undef TERN_MAX_ACTIVE
#undef TERN_MAX_PLANES
#undef TERN_MAX_SEPARATIONS
#define TERN_MAX_SEGMENTS 16
#define TERN_MAX_ACTIVE 96
#define TERN_MAX_PLANES 24
#define TERN_MAX_SEPARATIONS 2

#include <gtest/gtest.h>

#include "qp/solver.hpp"

namespace {

constexpr std::size_t kKilobyte = 1024;

static_assert(sizeof(tern::QpSolver) <= 320 * kKilobyte, "the solver's working memory");
static_assert(sizeof(tern::QpProblem) <= 150 * kKilobyte, "the programme, a caller's");
static_assert(sizeof(tern::QpSolution) <= 4 * kKilobyte, "the answer, a caller's");

TEST(QpMemory, WhatIsNotTheFactorGrowsWithSegmentsAlone) {
  const std::size_t factor = sizeof(tern::QpSolver::basis) + sizeof(tern::QpSolver::triangle);
  EXPECT_LE(sizeof(tern::QpSolver) - factor, 9 * kKilobyte * tern::kMaxSegments);
  EXPECT_LE(factor, std::size_t{1536} * tern::kMaxActive + 8 * tern::kMaxActive * tern::kMaxActive);
}

}  // namespace
