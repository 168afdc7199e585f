// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every golden plan that begins at rest, flown by simulated vehicles: what is off the plan stays within the margins of
// docs/simulator.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "golden/corpus_run.hpp"
#include "host/flight/flown_plan.hpp"

namespace {

/// Limits up to `v` and `a` need this tracking margin.
struct Margin {
  double v, a, metres;
};

/// The largest error of a vehicle over all golden plans within the limits.
double largest_error(const char* kind, const Margin& margin, int& flown) {
  const auto memory = std::make_unique<tern_golden::Memory>();
  tern_host::FlightSettings settings;
  settings.tracking = kind;
  double largest = 0.0;
  tern_golden::run_corpus(*memory, [&](int, tern::Status status, const tern::Report&, std::uint64_t) {
    const tern::Request& request = memory->scenario.request;
    const bool rests = request.start.velocity.x == 0.0 && request.start.velocity.y == 0.0;
    const bool fits = request.limits.v_max.x <= margin.v && request.limits.a_max.x <= margin.a;
    if (status != tern::Status::kOk || !rests || !fits) return;
    largest = std::max(largest, tern_host::fly_plan(memory->trajectory, settings).tracking_max);
    ++flown;
  });
  return largest;
}

void expect_within(const char* kind, const Margin& margin) {
  int flown = 0;
  const double largest = largest_error(kind, margin, flown);
  std::printf("%s up to %g m/s and %g m/s^2: %d plans, at most %.3f m off\n", kind, margin.v, margin.a, flown, largest);
  EXPECT_GE(flown, 20);
  EXPECT_LE(largest, margin.metres);
}

TEST(FlownPlans, AGeometricControllerStaysWithinItsMargins) {
  expect_within("quadrotor", {2.0, 2.0, 0.02});
  expect_within("quadrotor", {4.0, 4.0, 0.04});
}

TEST(FlownPlans, Px4StaysWithinItsMargins) {
  expect_within("px4", {2.0, 2.0, 0.40});
  expect_within("px4", {4.0, 4.0, 0.60});
}

}  // namespace
