// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A Crazyflie takes more pieces than a plan has segments here.
#include "tern_stacks/stacks.hpp"

#include <gtest/gtest.h>

#include "support/yaw_case.hpp"

namespace {

using namespace tern;

TEST(TinyExport, PlansWithMoreSegmentsThanTheyCanHaveAreRefused) {
  static_assert(kMaxSegments + 1 < kCrazyfliePieces, "the pieces would not fit anyway");
  Trajectory trajectory = tern_test::hover(1.0);
  Poly4d pieces[kCrazyfliePieces];
  std::int32_t count = -1;
  ExportError error{};
  trajectory.count = kMaxSegments + 1;
  EXPECT_EQ(crazyflie_raw(trajectory, nullptr, {}, pieces, kCrazyfliePieces, count, error), Status::kInvalidArgument);
  EXPECT_EQ(count, -1);
}

}  // namespace
