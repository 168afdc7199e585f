// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From when on the watch holds a commit to the map and the fences, and which place a vehicle leaves. The plans are made
// by hand, so that each takes over when the test says.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "flight/branch.hpp"
#include "host/fence_record.hpp"
#include "host/flight/flight_watch.hpp"
#include "support/watched_room.hpp"
#include "tern/trajectory.hpp"

namespace {

constexpr std::int64_t kStep = 10000000;  // a tick, ns

/// A vehicle that rests at the start, and plans from rest to rest along x, one after the other.
struct PlannedByHand : tern_test::WatchedRoom {
  struct Plan {
    std::int64_t committed = 0;  ///< at this tick
    tern::Trajectory curve{};
  };

  /// Commits a plan that takes over 50 ms later, from what is commanded then, and rests at `x` 2 s later.
  void commit(std::int64_t at, double x) {
    const tern::Vec3 start = world.start;
    const std::int64_t begin = at + 5 * kStep;
    const tern::Sample from = command(begin);
    tern::JointState joint{};
    joint.d[0] = {from.position.x - start.x, from.position.y - start.y, from.position.z - start.z};
    joint.d[1] = from.velocity;
    joint.d[2] = from.acceleration;
    joint.d[3] = from.jerk;
    tern::JointState rest{};
    rest.d[0] = {x - start.x, 0.0, 0.0};
    Plan plan{at, {}};
    plan.curve.begin = begin;
    plan.curve.origin = start;
    ASSERT_TRUE(tern::append_between(joint, rest, 2.0, plan.curve));
    plans.push_back(plan);
  }

  /// After all commits that were made so far.
  tern::Sample command(std::int64_t t) const {
    tern::Sample sample{};
    sample.position = world.start;
    for (const Plan& plan : plans) {
      const bool flown = plan.committed <= now && plan.curve.begin <= t;
      if (flown) sample = tern::evaluate(plan.curve, 1e-9 * static_cast<double>(t - plan.curve.begin));
    }
    return sample;
  }

  std::string watch() {
    const tern::FlightSpec spec = tern::flight_spec(limits_of(world.settings));
    now = 0;
    const auto at = [this](std::int64_t t) { return command(t); };
    tern_host::FlightWatch watch(world, spec, map, {at, [this] { return command(kForEver).position; }});
    tern::FlightReport report{};
    for (std::int64_t t = 0; t < 600 * kStep; t += kStep) {
      watch.before(t);
      now = t;
      for (const Plan& plan : plans) report.committed += plan.committed == t ? 1 : 0;
      watch.look(t, report);
    }
    return watch.broken();
  }

  static constexpr std::int64_t kForEver = 1000000 * kStep;
  std::vector<Plan> plans;
  std::int64_t now = kForEver;  ///< what is committed later is not commanded yet
};

/// The commit is at 0.1 s and the takeover at 0.15 s. Until then the vehicle rests, and no keep-in need hold it.
TEST(FlightWatchTakeover, FencesCountFromThere) {
  const auto with_chain_from = [](std::int64_t from) {
    PlannedByHand w;
    w.commit(10 * kStep, 2.0);
    tern_host::FenceEnd end;
    end.from = from;
    end.until = 1000 * kStep;
    tern_host::add_fence({"keepin", "-2", "-5", "0", "12", "5", "4"}, {"", 0}, w.world.fences, end);
    return w.watch();
  };
  EXPECT_EQ(with_chain_from(0), "");
  EXPECT_EQ(with_chain_from(15 * kStep), "");
  EXPECT_TRUE(tern_test::says(with_chain_from(20 * kStep), "into a fence"));
}

/// What the watch says of a vehicle that rests 0.3 m beside a wall, within its radius of 0.35 m, flies 1 m away, and
/// then to `x`, with a plan that is committed `after` the first one.
std::string after_leaving(std::int64_t after, double x) {
  PlannedByHand w;
  w.world.start.x = -0.1;
  w.map.mark_box({{-2.0, -1.0, 0.0}, {-0.41, 1.0, 4.0}});
  w.commit(10 * kStep, 0.9);
  w.commit(10 * kStep + after, x);
  return w.watch();
}

TEST(FlightWatchTakeover, WhatTakesOverWhileItLeavesKeepsToThePlaceThatItLeft) {
  for (const std::int64_t after : {100, 160, 190}) {
    EXPECT_EQ(after_leaving(after * kStep, 1.5), "") << after;
    EXPECT_EQ(after_leaving(after * kStep, -0.08), "") << after;
    EXPECT_TRUE(tern_test::says(after_leaving(after * kStep, -0.11), "too near to unproven space")) << after;
  }
}

/// It rests after 2 s. Two ticks before counts as rest.
TEST(FlightWatchTakeover, WhatTakesOverAtRestLeavesThatPlace) {
  for (const std::int64_t after : {198, 200, 300}) {
    EXPECT_EQ(after_leaving(after * kStep, 1.5), "") << after;
    EXPECT_TRUE(tern_test::says(after_leaving(after * kStep, -0.08), "too near to unproven space")) << after;
  }
  EXPECT_EQ(after_leaving(197 * kStep, -0.08), "");
}

}  // namespace
