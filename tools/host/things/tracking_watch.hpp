// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How well a flight knows what its own sensor sees move, beside the truth.
#ifndef TERN_HOST_THINGS_TRACKING_WATCH_HPP
#define TERN_HOST_THINGS_TRACKING_WATCH_HPP

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "host/flight/depth_camera.hpp"
#include "host/flight/lidar.hpp"
#include "host/things/thing_motion.hpp"
#include "tern/track.hpp"

namespace tern_host {

/// A measurement that is of no thing.
constexpr std::size_t kNoThing = static_cast<std::size_t>(-1);

struct TrackingFigures {
  std::uint64_t scans = 0;
  std::uint64_t in_view = 0;       ///< things in all scans, of which at least eight pixels or beams hit each
  std::uint64_t missed = 0;        ///< of these, without a track that was measured in the last half second
  std::uint64_t entries = 0;       ///< how often a thing came into view, after a second at least out of it
  std::uint64_t births = 0;        ///< after how many of them it had a track before it was gone again
  double late = 0.0;               ///< from each entry to the scan that gave it a track, s, in all
  double latest = 0.0;             ///< and the longest one
  std::uint64_t told = 0;          ///< measurements
  std::uint64_t of_nothing = 0;    ///< of these, with no thing within a metre
  std::uint64_t outside = 0;       ///< of these, of a thing that was not in the tube when the flight was told
  std::uint64_t false_tracks = 0;  ///< that never were of a thing
};

class TrackingWatch {
 public:
  /// Both must outlive the watch.
  TrackingWatch(const std::vector<Thing>& things, const std::vector<ThingMotion>& motions)
      : things_(things), motions_(motions), views_(things.size()) {}

  /// The thing that is nearest to the middle of a track at the time of its measurement, if any is near.
  std::size_t thing_of(const tern::Track& track) const;
  /// The tracks that a frame or scan gave.
  template <typename Frame>
  void note(const Frame& frame, double range, const std::vector<tern::Track>& tracks);
  /// The flight was told of a track, at time t, ns.
  void note_told(const tern::Track& track, std::int64_t t);
  TrackingFigures figures() const;

 private:
  struct View {
    double entered = -1.0;  ///< s: when it came into view
    double last = -1e9;     ///< s: when it was in view
    double tracked = -1e9;  ///< s: when it was measured
    bool is_born = false;
  };

  void note_view(std::size_t thing, double now);

  const std::vector<Thing>& things_;
  const std::vector<ThingMotion>& motions_;
  std::vector<View> views_;
  std::set<std::uint32_t> real_, unreal_;  ///< tracks that were of a thing, and of nothing, at some time
  TrackingFigures figures_;
};

}  // namespace tern_host

#endif
