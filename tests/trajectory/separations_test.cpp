// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Planes between a chain and things that move: the prices of time against differences of solved programmes, and plans
// around things against dense samples.
#include "trajectory/separations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "curve/bezier.hpp"
#include "support/box_corridor.hpp"
#include "support/chain.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::Random;

struct Memory {
  Corridor corridor;
  Chain chain;
  Trajectory reference;
  Scene scene;
  TrajectoryStage stage;
  Trajectory plan;
};

/// A corridor of two long boxes, and as the reference the plan without things.
class Separated : public testing::Test {
 protected:
  bool begin(Random& random) {
    Memory& m = *memory_;
    m.corridor = tern_test::random_corridor(random, 2, 8.0, 1.2);
    query_ = TrajectoryQuery{};
    query_.start.position = m.corridor.polyhedra[0].from;
    query_.goal.position = m.corridor.polyhedra[1].to;
    query_.limits = limits_;
    query_.time_weight = kDefaultTimeWeight;
    tern_test::begin_trajectory(m.stage, m.corridor, query_);
    Work work{0xFFFFFFFFu};
    if (trajectory_advance(m.stage, m.corridor, work, m.reference) != Progress::kDone) return false;
    tern_test::make_chain(m.corridor, query_.start, query_.goal, limits_, m.chain);
    m.chain.count = m.reference.count;
    for (int i = 0; i < m.chain.count; ++i) {
      m.chain.duration[i] = 1.04 * m.reference.segments[i].duration;
      m.chain.polyhedron[i] = m.reference.segments[i].polyhedron;
    }
    return m.stage.quality == Quality::kOptimised;
  }

  /// A ball, a cylinder or a box that crosses the reference about when the plan is there, to the side.
  Track crossing(Random& random, double share) {
    const Memory& m = *memory_;
    double time = share * chain_duration(m.chain);
    int segment = 0;
    while (segment + 1 < m.chain.count && time > m.chain.duration[segment]) time -= m.chain.duration[segment++];
    const Segment& of = m.reference.segments[segment];
    const Vec3 at = value(curve_of(of), smaller(1.0, time / m.chain.duration[segment]));
    Track track;
    track.shape = static_cast<TrackShape>(random.integer(0, 2));
    track.radius = random.real(0.05, 0.2);
    track.half = {random.real(0.05, 0.2), random.real(0.05, 0.2), random.real(0.05, 0.2)};
    track.velocity = {random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-0.3, 0.3)};
    track.error = random.real(0.0, 0.05);
    track.error_speed = random.real(0.0, 0.05);
    track.error_growth = random.real(0.0, 0.02);
    const double when = share * chain_duration(m.chain);
    track.position = at - when * track.velocity + Vec3{0.0, random.real(-0.2, 0.2), random.real(-0.2, 0.2)};
    return track;
  }

  void set_scene(double radius) {
    Scene& scene = memory_->scene;
    scene.things = {tracks_.data(), static_cast<std::int32_t>(tracks_.size()), radius, kZero, 0};
    scene.reference = &memory_->reference;
    for (double& pause : scene.pause) pause = 0.0;
    scene.rest = 0.0;
  }

  /// The least snap at the chain's durations with the planes; negative where there is none.
  double solve(Separations& separations) {
    Memory& m = *memory_;
    assemble(m.chain, m.corridor, limits_, nullptr, m.stage.problem, m.stage.scale);
    Work work{0xFFFFFFFFu};
    EXPECT_TRUE(add_separations(m.chain, m.scene, separations, m.stage.scale, m.stage.problem, work));
    qp_begin(m.stage.solver, m.stage.problem, nullptr, 0);
    if (qp_advance(m.stage.solver, m.stage.problem, work, m.stage.solution) != Status::kOk) return -1.0;
    read_points(m.chain, m.stage.scale, m.stage.solution, m.stage.points);
    double snap = 0.0;
    for (int i = 0; i < m.chain.count; ++i) {
      Segment segment{};
      segment.duration = m.chain.duration[i];
      for (int k = 0; k < kControlPoints; ++k) segment.points[k] = m.stage.points[i][k];
      const Curve curve = snap_of(segment);
      snap += integral_of_product(curve, curve, segment.duration);
    }
    return snap;
  }

  std::unique_ptr<Memory> memory_ = std::make_unique<Memory>();
  std::vector<Track> tracks_;
  TrajectoryQuery query_{};
  MotionLimits limits_ = Limits{{2.0, 2.0, 2.0}, {3.0, 3.0, 3.0}};
};

TEST_F(Separated, PricesAreTheDerivativeOfTheLeastSnap) {
  Random random(11);
  int compared = 0;
  int total = 0;
  const int cases = tern_test::scaled(120);
  for (int n = 0; n < cases; ++n) {
    if (!begin(random)) continue;
    Memory& m = *memory_;
    tracks_ = {crossing(random, random.real(0.25, 0.5)), crossing(random, random.real(0.5, 0.75))};
    set_scene(0.15);
    auto separations = std::make_unique<Separations>();
    separations_begin(m.scene, query_.start.position, *separations);
    for (int i = 0; i < m.chain.count; ++i) {
      for (int k = 0; k < kControlPoints; ++k) m.stage.points[i][k] = m.reference.segments[i].points[k];
    }
    Work work{0xFFFFFFFFu};
    meet_begin(true, *separations);
    ASSERT_TRUE(meet_advance(m.chain, m.scene, m.stage.points, *separations, work));
    const double snap = solve(*separations);
    if (snap < 0.0) continue;
    int pressing = 0;
    for (int r = 0; r < m.stage.solution.active_count; ++r) {
      pressing += m.stage.scale.origin[m.stage.solution.active[r].point].order == kSeparationOrder ? 1 : 0;
    }
    if (pressing == 0) continue;
    double prices[kMaxSegments];
    time_prices(m.chain, m.stage.problem, m.stage.solution, m.stage.scale, m.stage.points, prices);
    add_separation_prices(m.chain, m.stage.solution, m.stage.scale, m.stage.points, *separations, prices);
    for (int i = 0; i < m.chain.count; ++i) {
      constexpr double kStep = 1e-5;
      const double middle = m.chain.duration[i];
      m.chain.duration[i] = middle * (1.0 + kStep);
      const double longer = solve(*separations);
      m.chain.duration[i] = middle * (1.0 - kStep);
      const double shorter = solve(*separations);
      m.chain.duration[i] = middle;
      const double difference = (shorter - longer) / (2.0 * kStep);
      // A working set that changes within the step bends the difference: most cases must agree, not each.
      compared += std::fabs(prices[i] - difference) <= 1e-3 * (std::fabs(prices[i]) + 0.1 * snap) ? 1 : 0;
      ++total;
    }
  }
  EXPECT_GE(compared, total * 95 / 100) << total;
  EXPECT_GT(total, cases / 2);
}

TEST_F(Separated, PlansKeepOffThings) {
  Random random(12);
  int found = 0;
  const int cases = tern_test::scaled(100);
  for (int n = 0; n < cases; ++n) {
    if (!begin(random)) continue;
    Memory& m = *memory_;
    tracks_ = {crossing(random, random.real(0.3, 0.5)), crossing(random, random.real(0.5, 0.7))};
    set_scene(0.15);
    query_.scene = &m.scene;
    trajectory_begin(m.stage, m.corridor, query_, m.chain);
    Work work{0xFFFFFFFFu};
    const Progress progress = trajectory_advance(m.stage, m.corridor, work, m.plan);
    if (progress != Progress::kDone) {
      EXPECT_EQ(m.stage.status, Status::kNoTrajectory);
      continue;
    }
    bool leaves = false;
    for (int j = 0; j < 2; ++j) leaves = leaves || m.stage.separations.leave[j] >= 0.0;
    if (leaves) continue;
    ++found;
    double begin = 0.0;
    for (int i = 0; i < m.plan.count; ++i) {
      const double duration = m.plan.segments[i].duration;
      for (int k = 0; k <= 200; ++k) {
        const double s = begin + duration * k / 200.0;
        const Vec3 at = value(curve_of(m.plan.segments[i]), k / 200.0);
        for (const Track& track : tracks_) {
          const Vec3 from = at - track.position - s * track.velocity;
          const double error = track.error + s * (track.error_speed + 0.5 * s * track.error_growth);
          const double ball = track.shape == TrackShape::kBall ? track.radius : 0.0;
          EXPECT_GE(distance(from, closest_in(Things{}, track, from)), 0.15 + ball + error - 1e-6);
        }
      }
      begin += duration;
    }
  }
  EXPECT_GT(found, cases / 2);
}

TEST_F(Separated, MoreThanFitEndTheStage) {
  Random random(13);
  int full = 0;
  const int cases = tern_test::scaled(20);
  for (int n = 0; n < cases; ++n) {
    if (!begin(random)) continue;
    Memory& m = *memory_;
    const Track one = crossing(random, 0.5);
    tracks_.assign(static_cast<std::size_t>(kMaxTracks), one);
    // So large that each segment comes near each track.
    for (Track& track : tracks_) track.error = 3.0;
    set_scene(0.15);
    query_.scene = &m.scene;
    trajectory_begin(m.stage, m.corridor, query_, m.chain);
    Work work{0xFFFFFFFFu};
    if (m.chain.count * kMaxTracks <= kMaxSeparations) continue;
    EXPECT_EQ(trajectory_advance(m.stage, m.corridor, work, m.plan), Progress::kFailed);
    full += m.stage.status == Status::kSeparationsFull ? 1 : 0;
  }
  EXPECT_GT(full, 0);
}

}  // namespace
