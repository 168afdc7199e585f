// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A curve that is exported is proven clear of things that move and of fences for a while, at the scenario's time.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "host/export/export_proof.hpp"
#include "host/scenario.hpp"
#include "host/session.hpp"

namespace {

const std::string kWorld = "boundary 0 0 0 12 8 3\nradius 0.3\nstart 1 4 1.5\ngoal 11 4 1.5\nstart_time 100\n";

tern_host::Scenario with(const std::string& records) {
  return tern_host::parse_scenario(kWorld + records, "test");
}

TEST(ExportAmong, ProvesTheCurveInTime) {
  tern_host::Session session;
  const tern_host::PlanResult result = session.plan(with(""));
  ASSERT_TRUE(result.ok());
  tern::ExportError error{};
  error.position = 1.0;  // so that the curve needs a proof of its own
  const tern::Vec3 origin{};
  const tern_host::ExportCase what{result.trajectory, error, &result.trajectory, origin};
  const std::string proven = "proven clear and within the limits";
  EXPECT_EQ(prove_export(with(""), what), proven);
  EXPECT_EQ(prove_export(with("track a ball 0.3 at 6 4 1.5 from 0 until 99 gone\n"), what), proven);
  EXPECT_THROW(prove_export(with("track a ball 0.3 at 6 4 1.5 from 0 until 105 gone\n"), what), std::runtime_error);
  EXPECT_EQ(prove_export(with("keepin 0 0 0 12 8 3 during 99 120\n"), what), proven);
  EXPECT_THROW(prove_export(with("keepin 0 0 0 12 8 3 during 99 103\n"), what), std::runtime_error);
}

}  // namespace
