// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Replans along a plan of one's own, on the map that it was made on: none arrives later than the rest of that plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "golden/corpus_run.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;

/// What replans along plans did.
struct Replans {
  int asked = 0;
  int found = 0;
  int sooner = 0;
  int followed = 0;
  double latest = -1e9;  ///< later than the rest, s
  double jumps[3] = {};  ///< of velocity, acceleration and jerk where the new plan begins
};

double apart(const Vec3& a, const Vec3& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

bool same_bits(const Vec3& a, const Vec3& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// The rest of a plan is that plan: whatever time it is asked for, before it was entered, too.
void expect_same_flight(const Trajectory& rest, const Trajectory& flown) {
  EXPECT_EQ(rest.begin, flown.begin);
  const double end = duration(flown);
  ASSERT_EQ(duration(rest), end);
  constexpr int kTimes = 64;
  for (int k = 0; k <= kTimes; ++k) {
    const Sample a = evaluate(rest, end * k / kTimes);
    const Sample b = evaluate(flown, end * k / kTimes);
    EXPECT_TRUE(same_bits(a.position, b.position) && same_bits(a.velocity, b.velocity) &&
                same_bits(a.acceleration, b.acceleration) && same_bits(a.jerk, b.jerk) && same_bits(a.snap, b.snap));
  }
}

/// Asks for a new plan at time t of the one that is flown; true if there is one.
bool replan(const Grid& grid, Planner& planner, Request& request, const Trajectory& flown, double t, Trajectory& next,
            Report& report, Replans& out) {
  const Sample now = evaluate(flown, t);
  request.start = {now.position, now.velocity, now.acceleration, now.jerk};
  request.previous = &flown;
  request.previous_time = t;
  const double rest = duration(flown) - t;
  ++out.asked;
  const Status status = planner.plan(grid, request, next, report);
  EXPECT_EQ(status, Status::kOk) << t;
  if (status != Status::kOk) return false;
  ++out.found;
  for (const StageReport& stage : report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
  const double left = duration(next) - report.entered;
  out.latest = std::max(out.latest, left - rest);
  out.sooner += left < rest - 1e-6 ? 1 : 0;
  EXPECT_LE(left, rest + 1e-6) << t;
  const bool follows = report.quality == Quality::kPrevious;
  out.followed += follows ? 1 : 0;
  EXPECT_EQ(report.entered, follows ? t : 0.0);
  if (follows) expect_same_flight(next, flown);
  const Sample first = evaluate(next, report.entered);
  EXPECT_EQ(apart(first.position, now.position), 0.0);
  out.jumps[0] = std::max(out.jumps[0], apart(first.velocity, now.velocity));
  out.jumps[1] = std::max(out.jumps[1], apart(first.acceleration, now.acceleration));
  out.jumps[2] = std::max(out.jumps[2], apart(first.jerk, now.jerk));
  return true;
}

/// Flies a plan and asks for a new one every 0.3 s, always to the same goal. `chained`: goes on along the new plan.
void replan_along(const Grid& grid, Planner& planner, Request request, bool chained, Replans& out) {
  constexpr double kEvery = 0.3;
  Trajectory flown{};
  Report report{};
  if (planner.plan(grid, request, flown, report) != Status::kOk) return;
  Trajectory next{};
  for (double t = kEvery; t < duration(flown) - 0.01; t += kEvery) {
    if (!replan(grid, planner, request, flown, t, next, report, out) || !chained) continue;
    flown = next;
    t = report.entered;
  }
}

/// Asks for a new plan right before each joint, where too little is left of a segment to cut it off.
void replan_before_joints(const Grid& grid, Planner& planner, Request request, Replans& out) {
  Trajectory flown{};
  Report report{};
  if (planner.plan(grid, request, flown, report) != Status::kOk) return;
  Trajectory next{};
  double joint = 0.0;
  for (int i = 0; i + 1 < flown.count; ++i) {
    joint += flown.segments[i].duration;
    for (const double before : {1.1e-3, 9e-4, 2e-4, 3e-5, 1e-6, 1e-9})
      replan(grid, planner, request, flown, joint - before, next, report, out);
  }
}

TEST(Replans, NeverArriveLaterThanTheRest) {
  const auto memory = std::make_unique<tern_golden::Memory>();
  Planner planner(&memory->workspace, sizeof memory->workspace);
  Replans replans;
  Replans before_joints;
  constexpr int kEveryForest = 5;
  const int forests = tern_test::scaled((tern_golden::kScenarioCount - tern_golden::kMapCount) / kEveryForest);
  for (int k = 0; k < tern_golden::kMapCount + forests; ++k) {
    const int forest = k - tern_golden::kMapCount;
    const int i = forest < 0 ? k : tern_golden::kMapCount + kEveryForest * forest;
    Grid grid;
    ASSERT_TRUE(tern_golden::scenario(i, memory->scenario));
    ASSERT_EQ(tern_golden::build_grid(memory->scenario, memory->words, tern_golden::kGridWords, grid), Status::kOk);
    replan_along(grid, planner, memory->scenario.request, false, replans);
    replan_along(grid, planner, memory->scenario.request, true, replans);
    replan_before_joints(grid, planner, memory->scenario.request, before_joints);
  }
  EXPECT_GT(before_joints.asked, 250);
  EXPECT_EQ(before_joints.found, before_joints.asked);
  EXPECT_GT(replans.asked, 300);
  EXPECT_EQ(replans.found, replans.asked);
  EXPECT_GT(replans.sooner, 0);
  EXPECT_GT(replans.followed, 100);
  EXPECT_LE(replans.jumps[0], 1e-13);
  EXPECT_LE(replans.jumps[1], 1e-10);
  EXPECT_LE(replans.jumps[2], 1e-5);
}

}  // namespace
