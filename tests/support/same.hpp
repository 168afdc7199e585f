// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_SAME_HPP
#define TERN_TESTS_SUPPORT_SAME_HPP

#include <gtest/gtest.h>

#include "tern/vec3.hpp"

namespace tern_test {

/// To the bit, but for the sign of zero.
inline void expect_same(const tern::Vec3& a, const tern::Vec3& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.z, b.z);
}

inline void expect_near(const tern::Vec3& a, const tern::Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

}  // namespace tern_test

#endif
