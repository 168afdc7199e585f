// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A room with nothing in it that stands, for plans among things that move.
#ifndef TERN_TESTS_PLANNER_AMONG_HPP
#define TERN_TESTS_PLANNER_AMONG_HPP

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/random.hpp"
#include "support/world.hpp"

namespace tern_test {

inline constexpr std::int64_t kSecond = 1000000000;
inline constexpr double kForever = std::numeric_limits<double>::infinity();

inline tern::Track ball(const tern::Vec3& place, const tern::Vec3& velocity, double radius = 0.3) {
  tern::Track track;
  track.position = place;
  track.velocity = velocity;
  track.radius = radius;
  return track;
}

/// 8 x 4 x 2 m with nothing in it that stands, and a request along its middle: some seven seconds.
class Among : public testing::Test {
 protected:
  Among() : world_({80, 40, 20}, 0.1, 0.2) { world_.from({0.55, 2.05, 1.05}).to({7.45, 2.05, 1.05}); }

  tern::Status plan(const std::vector<tern::Track>& tracks) {
    tracks_ = tracks;
    world_.request.tracks = tracks_.data();
    world_.request.track_count = static_cast<std::int32_t>(tracks_.size());
    return world_.plan();
  }

  /// A plan that is proven by a proof that knows nothing of the planner.
  void expect_plan(double rest = 0.0) {
    ASSERT_EQ(world_.report.status, tern::Status::kOk);
    tern::TrackGrounds grounds;
    grounds.tracks = tracks_.data();
    grounds.count = world_.request.track_count;
    grounds.radius = world_.spec.radius;
    grounds.rest = rest;
    grounds.leaves = true;
    grounds.fences = world_.request.fences;
    grounds.fence_count = world_.request.fence_count;
    tern::ProofReport found;
    tern::clear_until(world_.trajectory, world_.report.entered, grounds, &found);
    EXPECT_EQ(found.finding, tern::Finding::kNone);
  }

  void expect_refused(tern::Status status, std::int32_t track) {
    EXPECT_EQ(world_.report.status, status);
    EXPECT_EQ(world_.report.track, track);
    EXPECT_TRUE(world_.trajectory_untouched());
  }

  World world_;
  std::vector<tern::Track> tracks_;
};

}  // namespace tern_test

#endif
