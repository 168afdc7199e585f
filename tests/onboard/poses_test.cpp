// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/poses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "onboard/onboard_sky.hpp"

namespace {

using tern_onboard::Fault;
using tern_onboard::Notices;
using tern_onboard::PoseAt;
using tern_onboard::Poses;
using tern_onboard::StampedPose;
using tern_test::kMs;

StampedPose pose_of(std::int64_t stamp, const tern::Vec3& position, double yaw = 0.0) {
  return {stamp, {position, {std::cos(0.5 * yaw), 0.0, 0.0, std::sin(0.5 * yaw)}}};
}

struct Ring {
  /// Adds a pose as soon as it is true.
  bool add(const StampedPose& pose, std::uint32_t resets = 0) { return poses.add(pose, resets, pose.stamp, notices); }
  std::uint64_t count(Fault fault) const { return notices.counts()[static_cast<std::size_t>(fault)]; }
  Notices notices;
  Poses poses{tern_onboard::WatchSettings{}};
};

TEST(Poses, InterpolateBetweenStamps) {
  Ring ring;
  for (int k = 0; k <= 10; ++k) ring.add(pose_of(20 * kMs * k, {0.1 * k, 0.0, 1.0}, 0.02 * k));
  tern::Pose pose{};
  ASSERT_EQ(ring.poses.at(105 * kMs, pose), PoseAt::kKnown);
  EXPECT_NEAR(pose.position.x, 0.525, 1e-12);
  EXPECT_NEAR(tern_onboard::heading_of(pose.quaternion), 0.105, 1e-12);
  ASSERT_EQ(ring.poses.at(100 * kMs, pose), PoseAt::kKnown);
  EXPECT_NEAR(pose.position.x, 0.5, 1e-12);
  EXPECT_EQ(ring.poses.at(-1, pose), PoseAt::kGone);
  EXPECT_EQ(ring.poses.at(200 * kMs + 1, pose), PoseAt::kNotYet);
}

TEST(Poses, TurnTheShorterWayBetweenAttitudes) {
  Ring ring;
  const double third = 2.0 * std::acos(-1.0) / 3.0;
  StampedPose last = pose_of(100 * kMs, {}, 0.2 - third);
  for (double& q : last.pose.quaternion) q = -q;  // the same attitude
  const tern::Pose middle = tern_onboard::between(pose_of(0, {}, 0.2 + third).pose, last.pose, 0.5);
  EXPECT_NEAR(std::abs(std::remainder(tern_onboard::heading_of(middle.quaternion) - 0.2, 2.0 * std::acos(-1.0))),
              std::acos(-1.0), 1e-12);
}

TEST(Poses, FallOutOfTheRingAndLeaveGaps) {
  Ring ring;
  for (int k = 0; k < 3000; ++k) ring.add(pose_of(10 * kMs * k, {0.0, 0.0, 1.0}));
  tern::Pose pose{};
  EXPECT_EQ(ring.poses.at(10 * kMs * (3000 - 1024), pose), PoseAt::kKnown);
  EXPECT_EQ(ring.poses.at(10 * kMs * (3000 - 1025), pose), PoseAt::kGone);
  ring.add(pose_of(30300 * kMs, {0.0, 0.0, 1.0}));  // pose_gap is 150 ms
  EXPECT_EQ(ring.poses.at(30200 * kMs, pose), PoseAt::kGap);
}

TEST(Poses, RefuseStampsAndNumbersThatAreWrong) {
  Ring ring;
  const std::int64_t now = 1000 * kMs;
  ASSERT_TRUE(ring.poses.add(pose_of(now, {1.0, 0.0, 0.0}), 0, now, ring.notices));
  const auto refused = [&](StampedPose pose, Fault fault) {
    const std::uint64_t before = ring.count(fault);
    EXPECT_FALSE(ring.poses.add(pose, 0, now, ring.notices));
    EXPECT_EQ(ring.count(fault), before + 1);
    EXPECT_EQ(ring.poses.newest()->stamp, now);
  };
  refused(pose_of(now, {1.0, 0.0, 0.0}), Fault::kPoseRepeated);
  refused(pose_of(now - kMs, {1.0, 0.0, 0.0}), Fault::kPoseBackward);
  refused(pose_of(now + 21 * kMs, {1.0, 0.0, 0.0}), Fault::kPoseAhead);
  refused(pose_of(now - 301 * kMs, {1.0, 0.0, 0.0}), Fault::kPoseOld);
  StampedPose bad = pose_of(now + kMs, {std::nan(""), 0.0, 0.0});
  refused(bad, Fault::kPoseInvalid);
  bad = pose_of(now + kMs, {});
  bad.pose.quaternion[0] = 1.1;
  refused(bad, Fault::kPoseInvalid);
  EXPECT_EQ(ring.notices.take().size(), 5u);  // each kind is said once
  refused(bad, Fault::kPoseInvalid);
  EXPECT_TRUE(ring.notices.take().empty());
}

TEST(Poses, FollowAJumpWithoutJumping) {
  Ring ring;
  tern::Vec3 jump{};
  for (int k = 0; k < 100; ++k) {
    if (k == 50) jump = {3.0, -2.0, 0.5};
    if (k == 70) jump = {};
    ring.add(pose_of(20 * kMs * k, tern_onboard::plus({0.06 * k, 0.0, 1.0}, jump)));
    // In the flight's frame, the vehicle goes on as it did.
    EXPECT_NEAR(ring.poses.newest()->pose.position.x, 0.06 * k, 1e-9);
    EXPECT_NEAR(ring.poses.newest()->pose.position.y, 0.0, 1e-9);
  }
  EXPECT_EQ(ring.count(Fault::kPoseJump), 2u);
  EXPECT_LT(tern_onboard::length(ring.poses.offset()), 1e-9);
}

TEST(Poses, FollowAResetThatIsAnnouncedHoweverSmall) {
  Ring ring;
  for (int k = 0; k < 10; ++k) ring.add(pose_of(20 * kMs * k, {0.0, 0.0, 1.0}), 7);
  ring.add(pose_of(200 * kMs, {0.1, 0.0, 1.0}), 8);
  EXPECT_NEAR(ring.poses.offset().x, 0.1, 1e-12);
  ring.poses.rebase();
  EXPECT_NEAR(ring.poses.newest()->pose.position.x, 0.1, 1e-12);
}

TEST(Poses, NoticeAHeadingThatJumps) {
  Ring ring;
  for (int k = 0; k < 10; ++k) EXPECT_TRUE(ring.add(pose_of(20 * kMs * k, {}, 0.1 * k)));
  EXPECT_FALSE(ring.add(pose_of(200 * kMs, {}, 2.0)));
  EXPECT_TRUE(ring.poses.heading_jumped());
  EXPECT_TRUE(ring.add(pose_of(220 * kMs, {}, 2.0)));
}

}  // namespace
