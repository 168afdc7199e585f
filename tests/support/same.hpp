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

}  // namespace tern_test

#endif
