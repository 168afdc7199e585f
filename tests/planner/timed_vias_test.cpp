// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ways through vias among things that no planes lead around: each leg has its flood.
#include <cstring>
#include <memory>

#include "base/math.hpp"
#include "planner/among.hpp"

namespace tern_test {
namespace {

using tern::Status;
using tern::Track;
using tern::Vec3;

class TimedVias : public Among {
 protected:
  TimedVias() {
    vias_.resize(2);
    vias_[0].position = {2.55, 2.05, 1.05};
    vias_[1].position = {6.05, 2.05, 1.05};
    for (tern::Via& via : vias_) via.tolerance = 0.2;
    world_.request.vias = vias_.data();
    world_.request.via_count = 2;
  }

  /// A wall across the room from y = `from` to `to`, half way between the vias; there from one second to another.
  static Track wall(double from, double to, double begin, double end) {
    Track track = ball({4.3, 0.5 * (from + to), 1.0}, {});
    track.shape = tern::TrackShape::kBox;
    track.half = {0.2, 0.5 * (to - from), 1.5};
    track.measured = static_cast<std::int64_t>(begin * kSecond);
    track.until = static_cast<std::int64_t>(end * kSecond);
    track.end = tern::TrackEnd::kGone;
    return track;
  }

  /// The plan is proven, passes the vias, and comes from a flood.
  void expect_flown() {
    expect_passed();
    EXPECT_EQ(world_.report.waits, 0.0);
    EXPECT_GE(world_.report.diagnostics.seed, 2);
    EXPECT_GT(world_.report.diagnostics.high_water.flood_words, 0);
  }

  /// The plan is proven, passes the vias, and rests before it flies the way that it has without things.
  void expect_waits(double least) {
    expect_passed();
    EXPECT_GE(world_.report.waits, least);
    EXPECT_EQ(world_.report.diagnostics.seed, 0);
    const auto waits = std::make_unique<tern::Trajectory>(world_.trajectory);
    ASSERT_EQ(plan({}), Status::kOk);
    ASSERT_EQ(waits->count, world_.trajectory.count + 1);
    for (int s = 0; s < world_.trajectory.count; ++s) {
      const tern::Segment& flies = world_.trajectory.segments[s];
      EXPECT_EQ(std::memcmp(waits->segments[s + 1].points, flies.points, sizeof flies.points), 0) << s;
    }
  }

  void expect_passed() {
    expect_plan(world_.request.rest_clear);
    if (world_.report.status != Status::kOk) return;
    for (std::size_t v = 0; v < vias_.size(); ++v) {
      EXPECT_LE(world_.report.vias[v].distance, vias_[v].tolerance + 1e-9) << v;
      const Vec3 passed = tern::evaluate(world_.trajectory, world_.report.vias[v].time).position;
      EXPECT_NEAR(tern::length(passed - vias_[v].position), world_.report.vias[v].distance, 1e-9) << v;
    }
    for (const tern::StageReport& stage : world_.report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
  }

  double lasts() const { return tern::duration(world_.trajectory); }

  std::vector<tern::Via> vias_;
};

/// It stays for good, so there is no plan without a flood.
TEST_F(TimedVias, WhatStandsBetweenThemIsPassed) {
  ASSERT_EQ(plan({}), Status::kOk);
  const double alone = lasts();
  ASSERT_EQ(plan({wall(-1.0, 2.7, 0.0, 1e9)}), Status::kOk);
  expect_flown();
  EXPECT_LT(lasts(), 1.5 * alone);
}

TEST_F(TimedVias, WhatClosesTheWayForAWhileIsWaitedFor) {
  ASSERT_EQ(plan({wall(-1.0, 5.0, 2.0, 12.0)}), Status::kOk);
  EXPECT_GT(world_.report.vias[1].time, 12.0);
  EXPECT_LT(lasts(), 15.0);
  expect_waits(9.0);
}

/// A dwell counts to where the plan waits.
TEST_F(TimedVias, AWaitAllowsForTheDwell) {
  vias_[0].stop = true;
  vias_[0].dwell = 4.0;
  ASSERT_EQ(plan({wall(-1.0, 5.0, 6.0, 14.0)}), Status::kOk);
  EXPECT_GT(world_.report.vias[1].time, 14.0);
  EXPECT_LT(lasts(), 17.2);
  expect_waits(4.5);
}

/// What stands at the via while the plan would dwell there is waited for before it.
TEST_F(TimedVias, AViaIsReachedOnceItStaysClear) {
  vias_[0].stop = true;
  vias_[0].dwell = 3.0;
  Track visitor = ball(vias_[0].position, {});
  visitor.measured = 4 * kSecond;
  visitor.until = 9 * kSecond;
  visitor.end = tern::TrackEnd::kGone;
  ASSERT_EQ(plan({visitor, wall(-1.0, 2.7, 0.0, 1e9)}), Status::kOk);
  expect_flown();
  EXPECT_GE(world_.report.vias[0].time, 9.0);
}

TEST_F(TimedVias, SlicesChangeNothing) {
  ASSERT_EQ(plan({wall(-1.0, 2.7, 0.0, 1e9)}), Status::kOk);
  const auto whole = std::make_unique<tern::Trajectory>(world_.trajectory);
  Status status = world_.planner.begin(world_.grid, world_.request);
  while (status == Status::kRunning) status = world_.planner.step(7);
  ASSERT_EQ(world_.planner.finish(world_.trajectory, world_.report), Status::kOk);
  EXPECT_EQ(std::memcmp(whole.get(), &world_.trajectory, sizeof(tern::Trajectory)), 0);
}

TEST_F(TimedVias, ManyThingsBetweenThemAreAvoided) {
  Random random(4173);
  const int cases = scaled(40);
  int floods = 0;
  for (int n = 0; n < cases; ++n) {
    std::vector<Track> tracks;
    for (int j = 0; j < 16; ++j) {
      const double y = random.integer(0, 1) == 0 ? -1.0 : 5.0;
      const double speed = y < 0.0 ? 0.6 : -0.6;
      tracks.push_back(ball({random.real(1.5, 7.0), y, random.real(0.3, 1.7)}, {0.0, speed, 0.0}, 0.2));
    }
    vias_[1].stop = random.integer(0, 1) == 1;
    vias_[1].dwell = vias_[1].stop ? random.real(0.0, 2.0) : 0.0;
    if (plan(tracks) != Status::kOk) continue;
    expect_plan();
    for (std::size_t v = 0; v < vias_.size(); ++v) EXPECT_LE(world_.report.vias[v].distance, 0.2 + 1e-9) << n;
    floods += world_.report.diagnostics.seed >= 2 ? 1 : 0;
  }
  if (cases >= 40) {
    EXPECT_GT(floods, 0);
  }
}

}  // namespace
}  // namespace tern_test
