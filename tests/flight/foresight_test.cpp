// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a look at a few instants says of a plan among things that move, against the proof.
#include "flight/foresight.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "support/random.hpp"
#include "tern/track_proof.hpp"

namespace {

using namespace tern;

constexpr double kClearance = 0.4;

/// From the origin 4 m along x, from rest to rest in 2 s.
Trajectory ahead() {
  Trajectory plan{};
  plan.count = 1;
  plan.segments[0].duration = 2.0;
  for (int k = 0; k < kControlPoints; ++k) plan.segments[0].points[k] = {k < 4 ? 0.0 : 4.0, 0.0, 0.0};
  return plan;
}

Track ball_at(const Vec3& place) {
  Track track;
  track.position = place;
  track.radius = 0.3;
  return track;
}

class Foresight : public ::testing::Test {
 protected:
  bool meets(const Trajectory& plan, double from) {
    Work work{1000};
    return meets_thing(plan, from, *table, kClearance, work);
  }
  const std::unique_ptr<TrackTable> table = std::make_unique<TrackTable>();
};

TEST_F(Foresight, SeesWhatIsAtTheEndOfAPlan) {
  table->clear();
  EXPECT_FALSE(meets(ahead(), 0.0));
  ASSERT_EQ(table->update(ball_at({4.0, 0.69, 0.0}), 0), Status::kOk);
  EXPECT_TRUE(meets(ahead(), 0.0));
  ASSERT_EQ(table->update(ball_at({4.0, 0.71, 0.0}), 0), Status::kOk);
  EXPECT_FALSE(meets(ahead(), 0.0));
  Track comes = ball_at({4.0, 2.71, 0.0});  // and is 0.71 m away after 2 s, less its error
  comes.velocity = {0.0, -1.0, 0.0};
  comes.error_growth = 0.02;
  ASSERT_EQ(table->update(comes, 0), Status::kOk);
  EXPECT_TRUE(meets(ahead(), 0.0));
}

// What the look says no to, no proof accepts.
TEST_F(Foresight, RefusesNothingThatCouldBeProven) {
  tern_test::Random random(4301);
  int refused = 0;
  int proven = 0;
  for (int k = 0; k < tern_test::scaled(400); ++k) {
    table->clear();
    for (std::uint32_t id = 0; id < 3; ++id) {
      Track track = ball_at({random.real(-2.0, 6.0), random.real(-3.0, 3.0), random.real(-2.0, 2.0)});
      track.id = id;
      track.shape = static_cast<TrackShape>(random.integer(0, 2));
      track.half = {random.real(0.1, 0.5), random.real(0.1, 0.5), random.real(0.1, 1.0)};
      track.velocity = {random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
      track.error_growth = random.real(0.0, 2.0);
      track.reach = random.chance(0.5) ? random.real(0.2, 2.0) : 0.0;
      track.measured = -random.integer(0, 500000000);
      ASSERT_EQ(table->update(track, 0), Status::kOk);
    }
    const Trajectory plan = ahead();
    const double from = random.real(0.0, 1.5);
    TrackGrounds grounds;
    grounds.tracks = table->tracks;
    grounds.count = table->count;
    grounds.radius = kClearance;
    ProofReport found;
    clear_until(plan, from, grounds, &found);
    const bool is_clear = found.finding == Finding::kNone;
    if (meets(plan, from)) {
      EXPECT_FALSE(is_clear) << k;
      ++refused;
    }
    proven += is_clear ? 1 : 0;
  }
  EXPECT_GT(refused, tern_test::scaled(400) / 10);
  EXPECT_GT(proven, tern_test::scaled(400) / 20);
}

}  // namespace
