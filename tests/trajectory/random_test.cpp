// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random corridors, limits and boundary states: whatever the stage gives out holds up to dense sampling.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "support/box_corridor.hpp"
#include "support/chain.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace {

using namespace tern;
using tern_test::kUnlimited;

class RandomCorridors : public testing::Test {
 protected:
  Status plan(const TrajectoryQuery& query) {
    std::memset(static_cast<void*>(stage_.get()), 0xA5, sizeof(TrajectoryStage));
    tern_test::begin_trajectory(*stage_, corridor_, query);
    Work work{kUnlimited};
    trajectory_advance(*stage_, corridor_, work, plan_);
    return stage_->status;
  }
  void expect_good(const TrajectoryQuery& query) const {
    expect_inside();
    expect_limits();
    expect_joints();
    expect_ends(query);
    expect_cost();
  }
  void expect_inside() const {
    for (int i = 0; i < plan_.count; ++i) {
      const Polyhedron& polyhedron = corridor_.polyhedra[plan_.segments[i].polyhedron];
      for (const Vec3& c : plan_.segments[i].points) {
        for (int p = 0; p < polyhedron.count; ++p) {
          const Vec3& n = polyhedron.planes[p].normal;
          EXPECT_LE(n.x * c.x + n.y * c.y + n.z * c.z, polyhedron.planes[p].offset + 1e-8);
        }
      }
    }
  }
  /// The highest parts of the limits that dense samples use.
  struct Use {
    double v = 0.0;
    double a = 0.0;
    double j = 0.0;
  };
  Use sampled_use() const {
    Use use;
    const double end = duration(plan_);
    const int steps = 60 * plan_.count;
    for (int i = 0; i <= steps; ++i) {
      const Sample s = evaluate(plan_, end * i / steps);
      use.v = std::fmax(use.v, part(s.velocity, limits_.v_max, limits_.v_min, limits_.v_horizontal));
      use.a = std::fmax(use.a, part(s.acceleration, limits_.a_max, limits_.a_min, limits_.a_horizontal));
      if (limits_.j_max.x > 0.0) use.j = std::fmax(use.j, part(s.jerk, limits_.j_max, {}, limits_.j_horizontal));
    }
    return use;
  }
  static double part(const Vec3& v, const Vec3& most, const Vec3& least, double horizontal) {
    const auto side = [](double x, double upper, double lower) {
      return std::fabs(x) / (x < 0.0 && lower < 0.0 ? -lower : upper);
    };
    const double box =
        std::fmax(std::fmax(side(v.x, most.x, least.x), side(v.y, most.y, least.y)), side(v.z, most.z, least.z));
    return horizontal > 0.0 ? std::fmax(box, std::hypot(v.x, v.y) / horizontal) : box;
  }
  void expect_limits() const {
    const Use use = sampled_use();
    EXPECT_LE(use.v, 1.0 + 1e-8);
    EXPECT_LE(use.a, 1.0 + 1e-8);
    EXPECT_LE(use.j, 1.0 + 3e-8);
  }
  void expect_joints() const {
    double at = 0.0;
    for (int i = 0; i + 1 < plan_.count; ++i) {
      EXPECT_EQ(std::memcmp(&plan_.segments[i].points[kDegree], &plan_.segments[i + 1].points[0], sizeof(Vec3)), 0);
      at += plan_.segments[i].duration;
      const Sample before = evaluate(plan_, at - 1e-9 * at);
      const Sample after = evaluate(plan_, at + 1e-9 * at);
      EXPECT_NEAR(before.velocity.x, after.velocity.x, 1e-6);
      EXPECT_NEAR(before.acceleration.y, after.acceleration.y, 1e-5);
      EXPECT_NEAR(before.jerk.z, after.jerk.z, 1e-3 * (1.0 + std::fabs(after.jerk.z)));
    }
  }
  void expect_ends(const TrajectoryQuery& query) const {
    const Sample first = evaluate(plan_, 0.0);
    EXPECT_EQ(first.position.x, query.start.position.x);
    EXPECT_NEAR(first.velocity.y, query.start.velocity.y, 1e-9);
    EXPECT_NEAR(first.acceleration.z, query.start.acceleration.z, 1e-7);
    EXPECT_NEAR(first.jerk.x, query.start.jerk.x, 1e-5);
    const Sample last = evaluate(plan_, std::nextafter(duration(plan_), 0.0));
    EXPECT_NEAR(last.position.x, query.goal.position.x, 1e-9);
    EXPECT_NEAR(last.velocity.y, query.goal.velocity.y, 1e-7);
    EXPECT_NEAR(last.acceleration.z, query.goal.acceleration.z, 1e-5);
  }
  void expect_cost() const {
    double sum = 0.0;
    for (int i = 0; i < plan_.count; ++i) {
      Trajectory one{};
      one.count = 1;
      one.segments[0] = plan_.segments[i];
      const int steps = 400;
      for (int k = 0; k < steps; ++k) {
        const Vec3 s = evaluate(one, one.segments[0].duration * (k + 0.5) / steps).snap;
        sum += (s.x * s.x + s.y * s.y + s.z * s.z) * one.segments[0].duration / steps;
      }
    }
    EXPECT_NEAR(snap_cost(plan_), sum, 1e-3 * sum + 1e-9);
  }
  TrajectoryQuery query_at_rest(tern_test::Random& random) {
    TrajectoryQuery query{};
    query.start.position = corridor_.polyhedra[0].from;
    query.goal.position = corridor_.polyhedra[corridor_.count - 1].to;
    query.limits = limits_ = tern_test::random_limits(random);
    query.time_weight = kDefaultTimeWeight;
    return query;
  }

  std::unique_ptr<TrajectoryStage> stage_ = std::make_unique<TrajectoryStage>();
  Corridor corridor_{};
  Limits limits_{};  ///< of the query, as the request has them
  Trajectory plan_{};
};

Vec3 part_of(tern_test::Random& random, const Vec3& limit, double part) {
  return {random.real(-part, part) * limit.x, random.real(-part, part) * limit.y, random.real(-part, part) * limit.z};
}

TEST_F(RandomCorridors, RestToRestAlwaysHasAPlanAndItIsGood) {
  tern_test::Random random(1);
  int optimised = 0;
  const int cases = tern_test::scaled(400);
  for (int i = 0; i < cases; ++i) {
    corridor_ = tern_test::random_corridor(random, random.integer(1, 12), 5.0, 0.05);
    const TrajectoryQuery query = query_at_rest(random);
    ASSERT_EQ(plan(query), Status::kOk) << i;
    optimised += stage_->quality == Quality::kOptimised ? 1 : 0;
    EXPECT_LE(stage_->solves, kMaxQpSolves);
    expect_good(query);
  }
  EXPECT_EQ(optimised, cases);
}

TEST_F(RandomCorridors, MovingEndsAreMetWhereThereIsAPlan) {
  tern_test::Random random(2);
  int planned = 0;
  const int cases = tern_test::scaled(300);
  for (int i = 0; i < cases; ++i) {
    corridor_ = tern_test::random_corridor(random, random.integer(1, 8), 5.0, 1.0);
    TrajectoryQuery query = query_at_rest(random);
    query.start.velocity = part_of(random, limits_.v_max, 0.5);
    query.start.acceleration = part_of(random, limits_.a_max, 0.4);
    if (random.chance(0.5)) query.goal.velocity = part_of(random, limits_.v_max, 0.4);
    if (random.chance(0.3)) query.goal.acceleration = part_of(random, limits_.a_max, 0.4);
    const Status status = plan(query);
    ASSERT_TRUE(status == Status::kOk || status == Status::kNoTrajectory);
    if (status != Status::kOk) continue;
    ++planned;
    expect_good(query);
  }
  EXPECT_GE(planned, cases * 6 / 10);
}

TEST_F(RandomCorridors, MoreWeightIsNeverSlower) {
  tern_test::Random random(9);
  int compared = 0;
  for (int i = 0; i < tern_test::scaled(60); ++i) {
    corridor_ = tern_test::random_corridor(random, random.integer(1, 8), 5.0, 0.3);
    TrajectoryQuery query = query_at_rest(random);
    if (i % 3 == 0) query.start.velocity = part_of(random, limits_.v_max, 0.5);
    double last = 0.0;
    for (const double weight : {40.0, 90.0, 100.0, 180.0, 200.0, 300.0, 450.0, 500.0, 900.0, 1e3, 5e3, 1e4, 1e6}) {
      query.time_weight = weight;
      if (plan(query) != Status::kOk) break;
      if (last > 0.0) {
        EXPECT_LE(duration(plan_), last * (1.0 + 1e-12)) << i << ", weight " << weight;
      }
      compared += last > 0.0 ? 1 : 0;
      last = duration(plan_);
    }
  }
  EXPECT_GE(compared, tern_test::scaled(60) * 4);
}

TEST_F(RandomCorridors, UnevenLimitsHoldAndAreReached) {
  tern_test::Random random(5);
  for (int i = 0; i < tern_test::scaled(300); ++i) {
    corridor_ = tern_test::random_corridor(random, random.integer(1, 8), 5.0, 0.05);
    TrajectoryQuery query = query_at_rest(random);
    query.limits = limits_ = tern_test::random_uneven_limits(random);
    query.time_weight = kMaxTimeWeight;
    ASSERT_EQ(plan(query), Status::kOk) << i;
    expect_good(query);
    const Use use = sampled_use();
    EXPECT_GE(std::fmax(use.v, use.a), 0.95) << i;
  }
}

TEST_F(RandomCorridors, UnevenLimitsHoldFromMovingStarts) {
  tern_test::Random random(6);
  int planned = 0;
  const int cases = tern_test::scaled(150);
  for (int i = 0; i < cases; ++i) {
    corridor_ = tern_test::random_corridor(random, random.integer(1, 8), 5.0, 1.0);
    TrajectoryQuery query = query_at_rest(random);
    query.limits = limits_ = tern_test::random_uneven_limits(random);
    query.start.velocity = part_of(random, {0.5, 0.5, 0.3}, 0.6);
    query.goal.velocity = part_of(random, {0.5, 0.5, 0.3}, 0.6);
    const Status status = plan(query);
    ASSERT_TRUE(status == Status::kOk || status == Status::kNoTrajectory);
    if (status != Status::kOk) continue;
    ++planned;
    expect_good(query);
  }
  EXPECT_GE(planned, cases * 9 / 10);
}

TEST_F(RandomCorridors, LimitsOnJerkHoldAndAreReached) {
  tern_test::Random random(10);
  int moving = 0;
  const int cases = tern_test::scaled(200);
  for (int i = 0; i < cases; ++i) {
    corridor_ = tern_test::random_corridor(random, random.integer(1, 8), 5.0, 0.3);
    TrajectoryQuery query = query_at_rest(random);
    Limits limits = tern_test::random_limits(random);
    const double j = random.real(0.5, 2.0) * limits.a_max.x;
    limits.j_max = {j, j, j};
    if (i % 4 == 0) limits.j_horizontal = 1.2 * j;
    query.limits = limits_ = limits;
    query.time_weight = kMaxTimeWeight;
    if (i % 5 == 4) query.stop_and_go = true;
    if (i % 2 == 1) {
      query.start.velocity = part_of(random, limits_.v_max, 0.3);
      query.start.acceleration = part_of(random, limits_.a_max, 0.1);
      query.start.jerk = part_of(random, limits_.j_max, 0.3);
    }
    const Status status = plan(query);
    if (i % 2 == 1 && status == Status::kNoTrajectory) continue;
    ASSERT_EQ(status, Status::kOk) << i;
    moving += i % 2;
    expect_good(query);
    const Use use = sampled_use();
    EXPECT_GE(std::fmax(std::fmax(use.v, use.a), use.j), i % 2 == 1 ? 0.5 : 0.9) << i;
  }
  EXPECT_GE(moving, cases / 4);
}

TEST_F(RandomCorridors, VeryUnequalLegs) {
  tern_test::Random random(3);
  for (int i = 0; i < tern_test::scaled(100); ++i) {
    corridor_ = Corridor{};
    Vec3 from{0, 0, 0};
    for (int k = 0; k < 5; ++k) {
      const double leg = k % 2 == 0 ? random.real(1e-6, 1e-3) : random.real(5.0, 50.0);
      const Vec3 to{from.x + leg * random.real(0.1, 1.0), from.y + leg * random.real(-1.0, 1.0), from.z};
      corridor_.polyhedra[corridor_.count++] = tern_test::box_around(from, to, random.real(0.01, 1.0));
      from = to;
    }
    const TrajectoryQuery query = query_at_rest(random);
    ASSERT_EQ(plan(query), Status::kOk) << i;
    expect_good(query);
  }
}

TEST_F(RandomCorridors, SlicesGiveTheSameBits) {
  tern_test::Random random(4);
  for (int i = 0; i < tern_test::scaled(60); ++i) {
    corridor_ = tern_test::random_corridor(random, random.integer(1, 8), 5.0, 0.1);
    const TrajectoryQuery query = query_at_rest(random);
    std::memset(static_cast<void*>(&plan_), 0, sizeof(plan_));
    ASSERT_EQ(plan(query), Status::kOk);
    const Trajectory whole = plan_;
    std::memset(static_cast<void*>(&plan_), 0, sizeof(plan_));
    tern_test::begin_trajectory(*stage_, corridor_, query);
    Progress progress = Progress::kMore;
    while (progress == Progress::kMore) {
      Work work{static_cast<std::uint32_t>(random.integer(1, 20))};
      progress = trajectory_advance(*stage_, corridor_, work, plan_);
    }
    EXPECT_EQ(std::memcmp(&whole, &plan_, sizeof(plan_)), 0);
  }
}

}  // namespace
