// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences for a while in exact numbers: room in one of several, and what a scenario asks of a plan.
#include <gtest/gtest.h>

#include "verify/fence_records.hpp"
#include "verify/fences.hpp"
#include "verify/track_records.hpp"

namespace tern_verify {
namespace {

Record record(const std::string& text) {
  return records_of(text, "test").front();
}

/// From 0 to 4 along x.
Polygon<3> line_along_x() {
  Polygon<3> curve;
  for (int k = 0; k < 8; ++k) curve.push_back({Rational(4 * k) / 7, 0, 0});
  return curve;
}

const Box kWorld{{-10, -10, -10}, {10, 10, 10}};

TEST(Windows, RecordsSayWhenTheyHold) {
  const Fence fence = fence_from(record("keepin 0 0 0 1 2 3 during 4 5.5 0.25"));
  ASSERT_TRUE(fence.window);
  EXPECT_EQ(fence.window->from, 4);
  EXPECT_EQ(fence.window->until, Rational(11) / 2);
  EXPECT_EQ(fence.window->clock_error, Rational(1) / 4);
  EXPECT_EQ(fence.planes.size(), 6u);
  EXPECT_FALSE(fence_from(record("keepin 0 0 0 1 2 3")).window);
  const Fence half = fence_from(record("keepout_halfspaces 1 0 0 2 during -1 1"));
  EXPECT_FALSE(half.keep_in);
  EXPECT_EQ(half.window->clock_error, 0);
  EXPECT_EQ(fence_from(record("keepin 0 0 0 1 2 3 during 4 5 zone Closed during events")).zone, "Closed during events");
  EXPECT_EQ(title_of({half, fence_from(record("keepin 0 0 0 1 2 3 zone Old \x1B town"))}, 1), "fence 2 (Old ? town)");
  EXPECT_EQ(title_of({half}, 0), "fence 1");
  EXPECT_THROW(fence_from(record("keepin 0 0 0 1 2 3 zone Lake during 4 5")), InputError);
  EXPECT_FALSE(is_track_record(record("keepout 0 0 0 1 2 3 zone Closed during events")));
  EXPECT_TRUE(is_track_record(record("keepout 0 0 0 1 2 3 during 4 5 zone Lake")));
  std::vector<Thing> things;
  add_track_record(record("keepout 0 0 0 1 2 3 during 4 5 zone Old \x1B town"), 7, things);
  EXPECT_EQ(things.at(0).name, "keepout 7 (Old ? town)");
  EXPECT_THROW(is_track_record(record("keepout 0 0 0 1 2 3 zone Lake during 4 5")), InputError);
  EXPECT_THROW(fence_from(record("keepin 0 0 0 1 2 3 during 4")), InputError);
  EXPECT_THROW(fence_from(record("keepin 0 0 0 1 2 3 during 4 4")), InputError);
  EXPECT_THROW(fence_from(record("keepin 0 0 0 1 2 3 during 4 5 -1")), InputError);
}

/// Two rooms that overlap from 1.5 to 2.5: the curve leaves the first one where it is half a metre inside the second.
TEST(Windows, RoomInOneOfSeveral) {
  const Fence first = fence_from(record("keepin -1 -1 -1 2.5 1 1"));
  const Fence second = fence_from(record("keepin 1.5 -2 -2 5 2 2"));
  const Rational close = decimal(2, 10);
  const FenceRoom both =
      fence_room({line_along_x()}, std::vector<std::vector<const Fence*>>{{&first, &second}}, kWorld);
  EXPECT_GE(both.least, Rational(1) / 2 - close);
  EXPECT_LE(both.most, Rational(1) / 2 + close);
  EXPECT_LT(abs(both.u - Rational(1) / 2), decimal(1, 3));
  const FenceRoom one = fence_room({line_along_x()}, std::vector<std::vector<const Fence*>>{{&first}}, kWorld);
  EXPECT_EQ(one.most, Rational(-3) / 2);
  EXPECT_LE(one.least, one.most);
}

}  // namespace
}  // namespace tern_verify
