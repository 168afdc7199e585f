// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/poses.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace tern_onboard {
namespace {

constexpr double kStrongest = 20.0;  // m/s^2: no multirotor changes its velocity faster
constexpr double kQuickest = 10.0;   // rad/s: nor its attitude

std::string metres(const tern::Vec3& v) {
  char text[80];
  std::snprintf(text, sizeof text, "%.2f %.2f %.2f m", v.x, v.y, v.z);
  return text;
}

}  // namespace

bool Poses::add(StampedPose pose, std::uint32_t resets, std::int64_t now, Notices& notices) {
  heading_jumped_ = false;
  if (!is_finite(pose.pose.position) || !make_unit(pose.pose.quaternion)) {
    notices.bad(Fault::kPoseInvalid, Notices::kNoSubject, now,
                "a pose is refused: its position is not finite, or its quaternion has not norm 1");
    return false;
  }
  if (!stamp_is_good(pose, now, notices)) return false;
  if (count_ > 0) {
    const StampedPose& last = get(count_ - 1);
    const double turned = angle_between(last.pose.quaternion, pose.pose.quaternion);
    heading_jumped_ = turned > settings_.heading_jump + kQuickest * seconds(pose.stamp - last.stamp);
    follow_jump(pose, resets != resets_, now, notices);
  }
  resets_ = resets;
  pose.pose.position = minus(pose.pose.position, offset_);
  if (count_ == kCapacity) first_ = (first_ + 1) % kCapacity;
  count_ = std::min(count_ + 1, kCapacity);
  ring_[(first_ + count_ - 1) % kCapacity] = pose;
  notices.good(Fault::kPoseInvalid, Fault::kPoseOld, Notices::kNoSubject, now, "poses are good again");
  return !heading_jumped_;
}

bool Poses::stamp_is_good(const StampedPose& pose, std::int64_t now, Notices& notices) const {
  const auto refuse = [&](Fault fault, const std::string& text) {
    notices.bad(fault, Notices::kNoSubject, now, text);
    return false;
  };
  if (pose.stamp > now + kStampAhead) {
    return refuse(Fault::kPoseAhead, "poses are refused: their stamps are " + milliseconds(pose.stamp - now) +
                                         " ahead of the clock. Synchronise the clocks of estimator and computer");
  }
  if (seconds(now - pose.stamp) > settings_.pose_age) {
    return refuse(Fault::kPoseOld, "poses are refused: their stamps are " + milliseconds(now - pose.stamp) +
                                       " behind the clock, and pose_age is less. Synchronise the clocks, or find what "
                                       "delays them");
  }
  if (count_ == 0 || pose.stamp > get(count_ - 1).stamp) return true;
  if (pose.stamp == get(count_ - 1).stamp) {
    return refuse(Fault::kPoseRepeated, "a pose is left out: it has the stamp of the last one");
  }
  return refuse(Fault::kPoseBackward,
                "a pose is left out: its stamp is before the last one's. Is there one source of poses?");
}

/// Where the estimate would be at `stamp` in the flight's frame if the vehicle went on as it did.
tern::Vec3 Poses::predicted(std::int64_t stamp) const {
  const StampedPose& last = get(count_ - 1);
  if (count_ < 2) return last.pose.position;
  const StampedPose& earlier = get(count_ - 2);
  const double share = static_cast<double>(stamp - last.stamp) / static_cast<double>(last.stamp - earlier.stamp);
  return plus(last.pose.position, times(minus(last.pose.position, earlier.pose.position), std::min(share, 10.0)));
}

void Poses::follow_jump(const StampedPose& pose, bool announced, std::int64_t now, Notices& notices) {
  const double dt = seconds(pose.stamp - get(count_ - 1).stamp);
  const tern::Vec3 step = minus(minus(pose.pose.position, offset_), predicted(pose.stamp));
  if (!announced && length(step) <= settings_.pose_jump + 0.5 * kStrongest * dt * dt) {
    notices.good(Fault::kPoseJump, Fault::kPoseJump, Notices::kNoSubject, now, "the estimate is steady again");
    return;
  }
  offset_ = plus(offset_, step);
  notices.bad(Fault::kPoseJump, Notices::kNoSubject, now,
              "the estimate jumped by " + metres(step) +
                  ". Map and plan go on where they are in the world, and goals keep their numbers");
}

PoseAt Poses::at(std::int64_t stamp, tern::Pose& pose) const {
  if (count_ == 0 || stamp > get(count_ - 1).stamp) return PoseAt::kNotYet;
  if (stamp < get(0).stamp) return PoseAt::kGone;
  std::size_t low = 0, high = count_ - 1;
  while (low < high) {  // the first pose that is not before the stamp
    const std::size_t middle = (low + high) / 2;
    if (get(middle).stamp < stamp) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const StampedPose& after = get(low);
  if (after.stamp == stamp) {
    pose = after.pose;
    return PoseAt::kKnown;
  }
  const StampedPose& before = get(low - 1);
  if (seconds(after.stamp - before.stamp) > settings_.pose_gap) return PoseAt::kGap;
  pose = between(before.pose, after.pose,
                 static_cast<double>(stamp - before.stamp) / static_cast<double>(after.stamp - before.stamp));
  return PoseAt::kKnown;
}

void Poses::rebase() {
  for (std::size_t k = 0; k < count_; ++k) {
    tern::Vec3& position = ring_[(first_ + k) % kCapacity].pose.position;
    position = plus(position, offset_);
  }
  offset_ = {};
}

}  // namespace tern_onboard
