// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records of plans.
#ifndef TERN_TESTS_RECORD_RECORDS_HPP
#define TERN_TESTS_RECORD_RECORDS_HPP

#include <gtest/gtest.h>

#include <vector>

#include "support/random.hpp"
#include "support/world.hpp"
#include "tern/record.hpp"

namespace tern_test {

using Bytes = std::vector<std::uint8_t>;

inline Bytes record(const tern_test::World& world) {
  Bytes bytes(tern::plan_record_bytes(world.spec.dims));
  std::size_t used = 0;
  EXPECT_EQ(tern::record_plan(world.grid, world.request, world.report.status, world.trajectory, bytes.data(),
                              bytes.size(), &used),
            tern::Status::kOk);
  bytes.resize(used);
  return bytes;
}

}  // namespace tern_test

#endif
