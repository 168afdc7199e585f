// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The k-th capacity fails in flight: of all questions of a whole flight whether a capacity or a budget is used up, one
// is answered with yes, or all that its place asks from then on. Plans fail, and so do brakes and proofs; what is flown
// stays clear of the obstacles, without jumps and within the limits, and ends at rest.
#include <gtest/gtest.h>

#include "capacity/cases_asked.hpp"
#include "capacity/hook.hpp"
#include "capacity/hop.hpp"
#include "tern/flight.hpp"

namespace tern_capacity {
namespace {

/// Questions of a flight in which nothing fails.
std::uint64_t questions(Surprise surprise) {
  Hop hop(surprise);
  begin();
  EXPECT_EQ(hop.fly(), "");
  end();
  EXPECT_EQ(hop.reason(), tern::FlightReason::kArrived);
  return asked();
}

void sweep(Surprise surprise, Failing how) {
  const std::uint64_t all = questions(surprise);
  ASSERT_GT(all, 1000u);
  const auto runs = static_cast<std::uint64_t>(cases(150));
  int arrived = 0;
  for (std::uint64_t k = 0; k < runs; ++k) {
    Hop hop(surprise);
    const std::uint64_t number = 2 + k * (all - 1) / runs;  // the first one is the goal's
    begin(number, how);
    // If no proof has room any more, no brake is proven or even judged: the flight reports a threat and flies on.
    const std::string wrong = hop.fly(how == Failing::kForGood);
    end();
    ASSERT_GE(asked(), number);
    EXPECT_EQ(wrong, "") << failed_site().file << ":" << failed_site().line << ", question " << number;
    const bool arrives = hop.reason() == tern::FlightReason::kArrived;
    arrived += arrives ? 1 : 0;
    // One failure costs a plan, and the next tick begins another one.
    EXPECT_TRUE(arrives || how == Failing::kForGood) << failed_site().file << ":" << failed_site().line << ", question "
                                                     << number << ", reason " << tern::flight_reason_text(hop.reason());
  }
  EXPECT_GT(arrived, 0);
  testing::Test::RecordProperty("number", static_cast<int>(runs));
}

TEST(CapacityFlight, OneQuestionFails) {
  sweep(Surprise::kNone, Failing::kOnce);
}
TEST(CapacityFlight, APlaceFailsForGood) {
  sweep(Surprise::kNone, Failing::kForGood);
}
TEST(CapacityFlight, OneQuestionFailsWhereAnObstacleTurnsUp) {
  sweep(Surprise::kFar, Failing::kOnce);
}
TEST(CapacityFlight, APlaceFailsForGoodWhereAnObstacleTurnsUp) {
  sweep(Surprise::kFar, Failing::kForGood);
}

}  // namespace
}  // namespace tern_capacity
