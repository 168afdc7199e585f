// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences without a point, in exact numbers: what is refused, and what only looks like it.
#include "verify/emptiness.hpp"

#include <gtest/gtest.h>

#include <string>

#include "verify/world.hpp"

namespace {

using namespace tern_verify;

const Box kRoom{{0, 0, 0}, {10, 8, 3}};

HalfSpace plane(const Rational& x, const Rational& y, const Rational& z, const Rational& offset) {
  return {{x, y, z}, offset};
}

std::vector<HalfSpace> box(const Rational& lower, const Rational& upper) {
  return {plane(1, 0, 0, upper),   plane(-1, 0, 0, -lower), plane(0, 1, 0, upper),
          plane(0, -1, 0, -lower), plane(0, 0, 1, upper),   plane(0, 0, -1, -lower)};
}

std::vector<HalfSpace> reversed(std::vector<HalfSpace> planes) {
  for (HalfSpace& plane : planes) plane = {Rational(-1) * plane.normal, -plane.offset};
  return planes;
}

TEST(Emptiness, FarFlatAndUnboundedFencesHavePoints) {
  EXPECT_FALSE(is_empty(box(1, 2), kRoom));
  EXPECT_FALSE(is_empty(box(2, 2), kRoom)) << "a point";
  EXPECT_FALSE(is_empty({plane(1, 0, 0, -50)}, kRoom));
  EXPECT_FALSE(is_empty({plane(1, 0, 0, 2), plane(-3, 0, 0, -6)}, kRoom)) << "a wall without thickness";
  for (const int far : {1000, 1000000000}) {
    EXPECT_FALSE(is_empty(box(far, far + 1), kRoom)) << far;
    EXPECT_FALSE(is_empty(box(far, far), kRoom)) << far;
  }
  // A wedge whose edge is a hundred metres away: y <= -100.
  EXPECT_FALSE(is_empty({plane(1, decimal(1, 2), 0, 0), plane(-1, decimal(1, 2), 0, -2)}, kRoom));
}

TEST(Emptiness, ReversedFencesHaveNone) {
  EXPECT_TRUE(is_empty(reversed(box(1, 2)), kRoom));
  EXPECT_TRUE(is_empty(reversed(box(1000000000, 1000000001)), kRoom));
  EXPECT_TRUE(is_empty({plane(1, 0, 0, 2), plane(-1, 0, 0, -2 - decimal(3, 9))}, kRoom));
  EXPECT_FALSE(is_empty({plane(1, 0, 0, 2), plane(-1, 0, 0, -2 - decimal(1, 9))}, kRoom)) << "forgiven";
  // A triangle the wrong way round, upright and leaning.
  for (const Rational& lean : {Rational(0), decimal(1, 2)}) {
    const std::vector<HalfSpace> triangle{plane(0, -1, lean, -1), plane(1, 1, lean, 6), plane(-1, 1, lean, 0)};
    EXPECT_FALSE(is_empty(triangle, kRoom));
    std::vector<HalfSpace> clockwise = reversed(triangle);
    clockwise.push_back(plane(0, 0, 1, 3));
    EXPECT_TRUE(is_empty(clockwise, kRoom));
  }
  // Parallel but for a rounding of their normals.
  EXPECT_TRUE(is_empty({plane(1, decimal(1, 16), 0, 2), plane(-1, 0, 0, -3)}, kRoom));
}

TEST(Emptiness, NamesTheFirstOne) {
  const Fence out{false, box(1, 2)};
  const Fence none{false, reversed(box(1, 2))};
  const Fence low{true, {plane(0, 0, 1, 1)}};
  const Fence high{true, {plane(0, 0, -1, -2)}};
  EXPECT_FALSE(empty_fence({out, low, out}, kRoom));
  EXPECT_EQ(empty_fence({out, none}, kRoom), 1u);
  EXPECT_EQ(empty_fence({low, out, high, none}, kRoom), 2u);
}

std::string message(const std::string& text, bool flight) {
  try {
    if (flight) {
      parse_world(text, "s.txt", {});
    } else {
      parse_problem(text, "s.txt");
    }
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Emptiness, FilesAreRefusedWithTheLine) {
  const std::string room = "boundary 0 0 0 10 8 3\nstart 1 4 1\ngoal 9 4 1\n";
  const std::string pillar = "keepout_halfspaces 1 0 0 6 -1 0 0 -4 0 1 0 6 0 -1 0 -2\n";
  const std::string clockwise = "keepout_halfspaces -1 0 0 -6 1 0 0 4 0 -1 0 -6 0 1 0 2\n";
  const std::string apart = "keepin 0 0 0 4 8 3\nkeepin 5 0 0 10 8 3\n";
  for (const bool flight : {false, true}) {
    EXPECT_EQ(message(room + pillar, flight), "");
    EXPECT_EQ(message(room + pillar + clockwise, flight),
              "s.txt:5: 'keepout_halfspaces': the keep-out is empty: no point is in it");
    EXPECT_EQ(message(clockwise + room, flight).substr(0, 9), "s.txt:1: ");
    EXPECT_EQ(message(room + apart, flight), "s.txt:5: 'keepin': no point is in this keep-in and those before it");
  }
}

}  // namespace
