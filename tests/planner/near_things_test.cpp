// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that rest right before the start or the goal, under a limit on jerk: there is a way around them.
#include <gtest/gtest.h>

#include <vector>

#include "support/random.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Status;
using tern::Track;
using tern::Vec3;

/// 28 x 28 x 6 m of empty space.
class NearThings : public testing::Test {
 protected:
  NearThings() : world_({112, 112, 24}, 0.25, 0.237) {}

  static Track ball(const Vec3& place, double radius) {
    Track track;
    track.position = place;
    track.radius = radius;
    return track;
  }

  Status plan(const std::vector<Track>& things) {
    world_.request.tracks = things.data();
    world_.request.track_count = static_cast<std::int32_t>(things.size());
    return world_.plan();
  }

  World world_;
};

TEST_F(NearThings, ABallRightAheadIsPassed) {
  world_.from({5.90983, 8.12215, 2.0}).to({22.09017, 19.87785, 2.0});
  world_.request.limits = {{10.0, 10.0, 10.0}, {20.0, 20.0, 20.0}};
  world_.request.limits.j_max = {30.0, 30.0, 30.0};
  ASSERT_EQ(plan({}), Status::kOk);
  const double alone = tern::duration(world_.trajectory);
  ASSERT_EQ(plan({ball({7.0, 8.9, 2.0}, 0.237)}), Status::kOk);
  EXPECT_LT(tern::duration(world_.trajectory), 1.1 * alone);
}

TEST_F(NearThings, OneToThreeBesideAnEndLeaveAWay) {
  Random random(41);
  for (int n = 0; n < scaled(200); ++n) {
    const Vec3 start{random.real(5.0, 10.0), random.real(10.0, 18.0), random.real(1.5, 4.0)};
    const Vec3 goal{random.real(18.0, 23.0), random.real(10.0, 18.0), random.real(1.5, 4.0)};
    world_.from(start).to(goal);
    const double v = random.real(2.0, 10.0);
    const double a = random.real(4.0, 20.0);
    const double j = random.real(15.0, 60.0);
    world_.request.limits = {{v, v, v}, {a, a, a}};
    world_.request.limits.j_max = {j, j, j};
    std::vector<Track> things;
    for (int k = random.integer(1, 3); k > 0; --k) {
      const bool is_at_goal = random.chance(0.5);
      const Vec3& end = is_at_goal ? goal : start;
      const double far = random.real(0.8, 3.0);
      const double ahead = is_at_goal ? -far : far;
      const double y = end.y + far * random.real(-0.5, 0.5);
      const double z = end.z + far * random.real(-0.5, 0.5);
      things.push_back(ball({end.x + ahead, y, z}, random.real(0.1, 0.3)));
    }
    EXPECT_EQ(plan(things), Status::kOk) << n;
  }
}

}  // namespace
}  // namespace tern_test
