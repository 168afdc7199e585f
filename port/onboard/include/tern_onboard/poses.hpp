// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Poses by stamp: a ring of the last ones, in which the pose at an image's stamp is found by interpolation.
#ifndef TERN_ONBOARD_POSES_HPP
#define TERN_ONBOARD_POSES_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tern_onboard/notices.hpp"
#include "tern_onboard/pose.hpp"
#include "tern_onboard/settings.hpp"

namespace tern_onboard {

inline double seconds(std::int64_t ns) {
  return 1e-9 * static_cast<double>(ns);
}

/// Nanoseconds that the stamp of a pose or a frame may be ahead of the clock: two computers, synchronised.
constexpr std::int64_t kStampAhead = 20000000;

/// What is known of a pose at one time.
enum class PoseAt : std::uint8_t {
  kKnown = 0,
  kNotYet,  ///< the newest pose is older: wait
  kGone,    ///< all poses are newer
  kGap,     ///< the poses around it are further apart than pose_gap
};

/// The last 1024 poses. Not thread-safe.
///
/// An estimate that jumps, for example when a position fix comes back, jumps only in its numbers: the vehicle does not.
/// So poses are kept in the flight's frame, in which nothing jumps: the estimate's frame, moved by offset(). After a
/// jump, offset() has grown by it. The map, the plans and the commands stay where they are in the true world.
class Poses {
 public:
  explicit Poses(const WatchSettings& settings) : settings_(settings), ring_(kCapacity) {}

  /// Takes a pose in the estimate's frame at time `now`. `resets`: a number that the estimator changes with every
  /// jump; always 0 if it has none. Then a step of more than pose_jump beyond the last velocity is a jump. False if it
  /// is refused, or if the heading jumped: `notices` has the reason.
  bool add(StampedPose pose, std::uint32_t resets, std::int64_t now, Notices& notices);
  /// The pose at `stamp`, in the flight's frame.
  PoseAt at(std::int64_t stamp, tern::Pose& pose) const;
  /// The newest pose, in the flight's frame; null if there is none.
  const StampedPose* newest() const { return count_ == 0 ? nullptr : &get(count_ - 1); }
  /// The estimate's frame minus the flight's: add it to a position of the flight for the autopilot.
  const tern::Vec3& offset() const { return offset_; }
  /// The heading jumped in the last add().
  bool heading_jumped() const { return heading_jumped_; }
  /// The flight's frame becomes the estimate's again.
  void rebase();
  /// Forgets all poses.
  void clear() { count_ = 0; }

 private:
  static constexpr std::size_t kCapacity = 1024;

  bool stamp_is_good(const StampedPose& pose, std::int64_t now, Notices& notices) const;
  void follow_jump(const StampedPose& pose, bool announced, std::int64_t now, Notices& notices);
  tern::Vec3 predicted(std::int64_t stamp) const;
  /// The k-th of the poses that are kept, the oldest first.
  const StampedPose& get(std::size_t k) const { return ring_[(first_ + k) % kCapacity]; }

  WatchSettings settings_;
  std::vector<StampedPose> ring_;
  std::size_t first_ = 0, count_ = 0;
  tern::Vec3 offset_{};
  std::uint32_t resets_ = 0;
  bool heading_jumped_ = false;
};

}  // namespace tern_onboard

#endif
