// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the trajectory stage does where programmes have no solution. No request is known to bring all of that about: the
// tests spoil the solver's answers between two slices.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "base/math.hpp"
#include "support/box_corridor.hpp"
#include "times/times_stage.hpp"
#include "trajectory/chain_ends.hpp"
#include "trajectory/stop_and_go.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace {

using namespace tern;
using tern_test::box_around;
using tern_test::kTwo;
using tern_test::resting;

/// A way along x through vias at x = 3 and x = `second`.
class Unsolved : public ::testing::Test {
 protected:
  void begin(double second, double first_reach, double second_reach) {
    const double ends[] = {0.0, 3.0, second, 8.0};
    corridor_->count = 3;
    for (int i = 0; i < 3; ++i) corridor_->polyhedra[i] = box_around({ends[i], 0, 1}, {ends[i + 1], 0, 1}, 0.4);
    via_joints_[0] = ViaJoint{1, 0, {3.0, 0, 1}, first_reach, false, false, {}};
    via_joints_[1] = ViaJoint{2, 0, {second, 0, 1}, second_reach, false, false, {}};
  }
  void start() {
    const State from = resting({0, 0, 1});
    const State to = resting({8, 0, 1});
    TimesStage times;
    Chain chain;
    Work work{0xFFFFFFFFu};
    times_begin(times, *corridor_, {from, to, kTwo, {via_joints_, 2}}, chain);
    times_advance(times, *corridor_, work, chain);
    std::memset(static_cast<void*>(&plan_), 0, sizeof plan_);
    trajectory_begin(*stage_, *corridor_, {from, to, kTwo, kDefaultTimeWeight}, chain);
  }
  /// Runs to the end; `judge(n)` is what the solver is made to say of programme n, or kOk to leave its answer.
  template <typename Judge>
  Status run(Judge judge) {
    Progress progress = Progress::kMore;
    while (progress == Progress::kMore) {
      const bool begun = stage_->phase == TrajectoryPhase::kSolve && stage_->solves > judged_;
      const Status said = begun ? judge(judged_) : Status::kOk;
      if (begun) judged_ = stage_->solves;
      if (said != Status::kOk) {
        stage_->solve_status = said;
        stage_->phase = TrajectoryPhase::kJudge;
      }
      Work work{1};
      progress = trajectory_advance(*stage_, *corridor_, work, plan_);
    }
    return stage_->status;
  }
  static Status nothing(int) { return Status::kIterationLimit; }
  /// How far the plan stays from a point.
  double distance_from(const Vec3& point) const {
    double least = 1e300;
    const double end = duration(plan_);
    for (int k = 0; k <= 10000; ++k) {
      const double off = distance(evaluate(plan_, end * k / 10000).position, point);
      least = off < least ? off : least;
    }
    return least;
  }

  std::unique_ptr<Corridor> corridor_ = std::make_unique<Corridor>();
  std::unique_ptr<TrajectoryStage> stage_ = std::make_unique<TrajectoryStage>();
  ViaJoint via_joints_[2] = {};
  Trajectory plan_;
  int judged_ = 0;
};

TEST_F(Unsolved, AnIllConditionedProgrammeGivesUpTheTolerances) {
  begin(5.0, 0.1, 0.0);
  start();
  ASSERT_EQ(run([](int n) { return n == 0 ? Status::kNumerical : Status::kOk; }), Status::kOk);
  EXPECT_EQ(stage_->quality, Quality::kOptimised);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(stage_->chain.via_joints[i].reach, 0.0) << i;
  EXPECT_GT(judged_, 1);
}

TEST_F(Unsolved, ItGivesThemUpOnce) {
  begin(5.0, 0.1, 0.1);
  start();
  ASSERT_EQ(run([](int) { return Status::kNumerical; }), Status::kOk);
  EXPECT_EQ(stage_->quality, Quality::kStopAndGo);
  EXPECT_EQ(stage_->optimiser, Status::kNumerical);
  EXPECT_LE(distance_from({3, 0, 1}), 1e-3);
  EXPECT_LE(distance_from({5, 0, 1}), 1e-3);
}

TEST_F(Unsolved, WithoutASolutionItFliesFromStopToStop) {
  begin(5.0, 0.0, 0.0);
  start();
  ASSERT_EQ(run(nothing), Status::kOk);
  EXPECT_TRUE(stage_->has_fallback) << "it was tried along stop-and-go's segments, too";
  EXPECT_EQ(stage_->quality, Quality::kStopAndGo);
  EXPECT_EQ(stage_->optimiser, Status::kIterationLimit);
  EXPECT_EQ(plan_.count, 3);
}

/// Two vias at one place: stop-and-go has no segment between them for a programme to begin from.
TEST_F(Unsolved, NorWhereTheWayStaysInAPlace) {
  begin(3.0, 0.0, 0.0);
  start();
  ASSERT_EQ(run(nothing), Status::kOk);
  EXPECT_TRUE(stage_->has_fallback);
  EXPECT_EQ(stage_->quality, Quality::kStopAndGo);
  EXPECT_EQ(plan_.count, 2);
}

TEST_F(Unsolved, AViaWithAVelocityIsNotFlownFromStopToStop) {
  begin(5.0, 0.0, 0.0);
  via_joints_[1].has_velocity = true;
  via_joints_[1].velocity = {1.0, 0.0, 0.0};
  start();
  EXPECT_EQ(run(nothing), Status::kNoTrajectory);
  EXPECT_FALSE(stage_->has_fallback);
  EXPECT_EQ(stage_->quality, Quality::kNone);
}

/// The ends' fitting gives up after 52 steps of 0.8, a factor of about 1e5.
class FittedEnds : public ::testing::Test {
 protected:
  FittedEnds() {
    corridor_->count = 2;
    corridor_->polyhedra[0] = box_around({0, 0, 0}, {1, 0, 0}, 0.5);
    corridor_->polyhedra[1] = box_around({1, 0, 0}, {2, 0, 0}, 0.5);
    std::memset(static_cast<void*>(&chain_), 0, sizeof chain_);
    chain_.count = 2;
    chain_.polyhedron[1] = 1;
    chain_.goal.d[0] = {2, 0, 0};
  }
  double fitted(double given) {
    chain_.duration[0] = chain_.duration[1] = given;
    Limits limits = kTwo;
    limits.j_max = {5.0, 5.0, 5.0};
    fit_ends(*corridor_, limits, chain_);
    return chain_.duration[0];
  }
  static double least_of(double given) {
    for (int i = 0; i < 52; ++i) given *= 0.8;
    return given;
  }
  std::unique_ptr<Corridor> corridor_ = std::make_unique<Corridor>();
  Chain chain_;
};

TEST_F(FittedEnds, AtRestNothingChanges) {
  EXPECT_EQ(fitted(1e4), 1e4);
}

TEST_F(FittedEnds, AnEndBeyondALimitNeverFits) {
  for (int k = 1; k <= 3; ++k) {
    for (Vec3& d : chain_.start.d) d = kZero;
    chain_.start.d[k] = {0.0, 6.0, 0.0};
    EXPECT_EQ(fitted(1e4), least_of(1e4)) << k;
    EXPECT_EQ(fitted(1.0), kMinDuration) << k;
    EXPECT_EQ(chain_.duration[1], 1.0);
  }
}

TEST_F(FittedEnds, NorDoesAViaThatIsPassedTooFast) {
  chain_.via_joint_count = 1;
  chain_.via_joints[0] = ViaJoint{1, 1, {1.0, 0.0, 0.0}, 0.0, false, true, {0.0, 600.0, 0.0}};
  EXPECT_EQ(fitted(1e4), least_of(1e4));
  EXPECT_EQ(chain_.duration[1], least_of(1e4));
  EXPECT_EQ(fitted(1.0), kMinDuration);
  chain_.via_joints[0].velocity = {0.0, 5.6, 0.0};  // a seventh of a duration leads 0.5 m away after 0.625 s
  const double fits = fitted(1.0);
  EXPECT_LE(fits, 0.625);
  EXPECT_GT(fits, 0.8 * 0.625);
}

TEST(Follow, HalvesSegmentsOnlyWhereTheyFit) {
  Trajectory plan{};
  Chain chain{};
  plan.count = kMaxSegments;
  for (int i = 0; i < plan.count; ++i) {
    plan.segments[i].duration = 2.0;
    plan.segments[i].polyhedron = i;
    for (int k = 0; k < kControlPoints; ++k) plan.segments[i].points[k] = {i + (k < kJointOrder ? 0.0 : 1.0), 0.0, 0.0};
  }
  follow(plan, chain);
  ASSERT_EQ(chain.count, kMaxSegments);
  EXPECT_EQ(chain.duration[1], 2.0);
  EXPECT_EQ(chain.length[1], 1.0);
  plan.count = kMaxSegments / 2;
  follow(plan, chain);
  ASSERT_EQ(chain.count, kMaxSegments);
  EXPECT_EQ(chain.polyhedron[3], 1);
  EXPECT_EQ(chain.duration[3], 1.0);
  EXPECT_EQ(chain.length[3], 0.5);
}

}  // namespace
