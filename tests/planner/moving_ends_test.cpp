// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans among random blocks from and to any velocity and acceleration within the limits. Whatever comes is held against
// the blocks and the limits by dense sampling; and where an end can stop straight ahead, by textbook kinematics after a
// short reaction, there is a plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::Limits;
using tern::State;
using tern::Status;
using tern::Vec3;

/// Seconds until a braking begins: acceleration is continuous, and ramps last 0.05 s at least, here on both sides.
constexpr double kReaction = 0.06;
/// Metres that the free space is taken smaller for it: blocks round to voxels.
constexpr double kRoom = 0.02;

double axis_of(const Vec3& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}

double lower_of(const Vec3& least, const Vec3& most, int a) {
  return axis_of(least, a) < 0.0 ? axis_of(least, a) : -axis_of(most, a);
}

/// A world of blocks on the lattice, kept beside the grid.
struct Blocks {
  std::vector<Box> boxes;
  Box boundary;
  double radius;

  double distance(const Vec3& p) const {
    double best = 1e9;
    for (const Box& box : boxes) {
      double squared = 0.0;
      for (int a = 0; a < 3; ++a) {
        const double d = std::max({axis_of(box.lower, a) - axis_of(p, a), 0.0, axis_of(p, a) - axis_of(box.upper, a)});
        squared += d * d;
      }
      best = std::min(best, std::sqrt(squared));
    }
    return best;
  }
  bool free(const Vec3& p, double margin) const {
    for (int a = 0; a < 3; ++a) {
      if (axis_of(p, a) < axis_of(boundary.lower, a) + margin) return false;
      if (axis_of(p, a) > axis_of(boundary.upper, a) - margin) return false;
    }
    return distance(p) >= radius + margin;
  }
};

/// Full deceleration straight ahead, after the reaction at the acceleration that the state has.
bool can_stop_straight(const Blocks& blocks, const State& state, const Limits& limits) {
  double time = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double v = axis_of(state.velocity, a) + kReaction * axis_of(state.acceleration, a);
    if (v > 0.98 * axis_of(limits.v_max, a) || v < 0.98 * lower_of(limits.v_min, limits.v_max, a)) return false;
    time = std::max(time, v < 0.0 ? -v / axis_of(limits.a_max, a) : v / -lower_of(limits.a_min, limits.a_max, a));
  }
  const Vec3 v = {state.velocity.x + kReaction * state.acceleration.x,
                  state.velocity.y + kReaction * state.acceleration.y,
                  state.velocity.z + kReaction * state.acceleration.z};
  for (int k = 0; k <= 100; ++k) {
    const double t = time * k / 100.0;
    const double way = kReaction + t - 0.5 * t * t / std::max(time, 1e-9);
    const Vec3& p = state.position;
    if (!blocks.free({p.x + way * v.x, p.y + way * v.y, p.z + way * v.z}, kRoom)) return false;
  }
  return true;
}

State turned_back(const State& state) {
  return {state.position, {-state.velocity.x, -state.velocity.y, -state.velocity.z}, state.acceleration};
}

Limits turned_back(const Limits& limits) {
  Limits result = limits;
  for (int a = 0; a < 3; ++a) {
    double& most = a == 0 ? result.v_max.x : (a == 1 ? result.v_max.y : result.v_max.z);
    double& least = a == 0 ? result.v_min.x : (a == 1 ? result.v_min.y : result.v_min.z);
    most = -lower_of(limits.v_min, limits.v_max, a);
    least = -axis_of(limits.v_max, a);
  }
  return result;
}

void expect_flyable(const World& world, const Blocks& blocks) {
  const Limits& limits = world.request.limits;
  const double end = tern::duration(world.trajectory);
  const int steps = 2000;
  for (int k = 0; k <= steps; ++k) {
    const tern::Sample sample = tern::evaluate(world.trajectory, end * k / steps);
    ASSERT_TRUE(blocks.free(sample.position, -1e-6)) << end * k / steps;
    for (int a = 0; a < 3; ++a) {
      ASSERT_LE(axis_of(sample.velocity, a), axis_of(limits.v_max, a) * (1.0 + 1e-6));
      ASSERT_GE(axis_of(sample.velocity, a), lower_of(limits.v_min, limits.v_max, a) * (1.0 + 1e-6));
      ASSERT_LE(axis_of(sample.acceleration, a), axis_of(limits.a_max, a) * (1.0 + 1e-6));
      ASSERT_GE(axis_of(sample.acceleration, a), lower_of(limits.a_min, limits.a_max, a) * (1.0 + 1e-6));
    }
  }
  const tern::Sample first = tern::evaluate(world.trajectory, 0.0);
  const tern::Sample last = tern::evaluate(world.trajectory, std::nextafter(end, 0.0));
  for (int a = 0; a < 3; ++a) {
    ASSERT_NEAR(axis_of(first.velocity, a), axis_of(world.request.start.velocity, a), 1e-6);
    ASSERT_NEAR(axis_of(first.acceleration, a), axis_of(world.request.start.acceleration, a), 1e-5);
    ASSERT_NEAR(axis_of(last.velocity, a), axis_of(world.request.goal.velocity, a), 1e-6);
    ASSERT_NEAR(axis_of(last.acceleration, a), axis_of(world.request.goal.acceleration, a), 1e-5);
  }
}

Vec3 within(Random& random, const Vec3& least, const Vec3& most) {
  return {random.real(lower_of(least, most, 0), most.x), random.real(lower_of(least, most, 1), most.y),
          random.real(lower_of(least, most, 2), most.z)};
}

Limits random_limits(Random& random) {
  Limits limits{{random.real(0.5, 3.0), random.real(0.5, 3.0), random.real(0.5, 2.0)},
                {random.real(1.0, 5.0), random.real(1.0, 5.0), random.real(1.0, 4.0)}};
  if (random.chance(0.5)) limits.v_min.z = -random.real(0.5, 1.5);
  if (random.chance(0.5)) limits.a_min.z = -random.real(1.0, 3.0);
  return limits;
}

class MovingEnds : public testing::Test {
 protected:
  /// Blocks on the lattice of an 8 x 8 x 3 m world.
  void fill(Random& random, World& world) {
    blocks_ = {{}, world.spec.boundary, world.spec.radius};
    const auto lattice = [&random](int lo, int hi) { return 0.1 * random.integer(lo, hi); };
    for (int k = random.integer(0, 14); k > 0; --k) {
      const Vec3 low{lattice(0, 70), lattice(0, 70), random.chance(0.5) ? 0.0 : lattice(0, 20)};
      const Vec3 high{std::min(8.0, low.x + lattice(2, 14)), std::min(8.0, low.y + lattice(2, 14)),
                      std::min(3.0, low.z + lattice(5, 30))};
      blocks_.boxes.push_back({low, high});
      world.block(low, high);
    }
  }
  bool random_free(Random& random, Vec3& point) const {
    for (int k = 0; k < 100; ++k) {
      point = {random.real(0.3, 7.7), random.real(0.3, 7.7), random.real(0.3, 2.7)};
      if (blocks_.free(point, 0.2)) return true;
    }
    return false;
  }
  /// Plans one case; counts it.
  void fly(Random& random, bool goal_moves) {
    World world({80, 80, 30}, 0.1, 0.2);
    fill(random, world);
    Vec3 from, to;
    if (!random_free(random, from) || !random_free(random, to)) return;
    world.from(from).to(to);
    tern::Request& request = world.request;
    request.limits = random_limits(random);
    request.start.velocity = within(random, request.limits.v_min, request.limits.v_max);
    request.start.acceleration = within(random, request.limits.a_min, request.limits.a_max);
    if (goal_moves) {
      request.goal.velocity = within(random, request.limits.v_min, request.limits.v_max);
      request.goal.acceleration = within(random, request.limits.a_min, request.limits.a_max);
    }
    const Status status = world.plan();
    if (status == Status::kNoPath) return;
    ASSERT_TRUE(status == Status::kOk || status == Status::kNoTrajectory) << tern::status_name(status);
    for (const tern::StageReport& stage : world.report.diagnostics.stages) ASSERT_LE(stage.work, stage.bound);
    const bool possible = can_stop_straight(blocks_, request.start, request.limits) &&
                          can_stop_straight(blocks_, turned_back(request.goal), turned_back(request.limits));
    possible_ += possible ? 1 : 0;
    missed_ += possible && status != Status::kOk ? 1 : 0;
    refused_ += status == Status::kOk ? 0 : 1;
    detours_ += world.report.diagnostics.detours;
    if (status != Status::kOk) {
      ASSERT_TRUE(world.trajectory_untouched());
    } else {
      ASSERT_NO_FATAL_FAILURE(expect_flyable(world, blocks_));
    }
  }

  Blocks blocks_;
  int possible_ = 0;
  int missed_ = 0;
  int refused_ = 0;
  int detours_ = 0;
};

TEST_F(MovingEnds, AnyStartThatCanStopStraightAheadIsPlanned) {
  Random random(23);
  for (int i = 0; i < scaled(300); ++i) {
    SCOPED_TRACE(i);
    ASSERT_NO_FATAL_FAILURE(fly(random, false));
  }
  EXPECT_EQ(missed_, 0) << "of " << possible_ << ", refused " << refused_;
  EXPECT_GE(possible_, scaled(300) / 3);
  EXPECT_GE(detours_, scaled(300) / 30);
}

TEST_F(MovingEnds, SoAreGoals) {
  Random random(24);
  for (int i = 0; i < scaled(200); ++i) {
    SCOPED_TRACE(i);
    ASSERT_NO_FATAL_FAILURE(fly(random, true));
  }
  EXPECT_EQ(missed_, 0) << "of " << possible_;
  EXPECT_GE(possible_, scaled(200) / 5);
}

}  // namespace
}  // namespace tern_test
