// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A tracker for detectors that have none: it gives detections identities and velocities.
#ifndef TERN_TRACKER_TRACKER_HPP
#define TERN_TRACKER_TRACKER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tern_onboard/sighting.hpp"

namespace tern_tracker {

struct TrackerSettings {
  double gate = 4.0;            ///< deviations, beyond which a detection is not of a track
  int hits = 2;                 ///< detections that make a track, at least 1
  double confirm_within = 0.3;  ///< s: how long a track that has not enough of them waits for the next one
  double lost_after = 1.0;      ///< s without a detection after which a track ends
};

/// Not thread-safe. Each track is a Kalman filter of a thing that keeps its velocity but for accelerations, whose
/// standard deviation is the largest one of its class. Detections go to tracks so that all of them together are
/// likeliest. README.md says how well that works.
class Tracker {
 public:
  explicit Tracker(const TrackerSettings& settings = {});
  ~Tracker();

  /// All detections of one scan, which was taken at `stamp`, ns; their names, stamps and velocities count for nothing.
  /// The tracks that were seen in it: detections with the names and velocities of their tracks, and deviations of the
  /// filters. A scan that is no newer than the last one is left out, and nothing is answered; but after one that is
  /// older by more than lost_after, it begins anew.
  std::vector<tern_onboard::Sighting> scan(std::int64_t stamp, const std::vector<tern_onboard::Sighting>& detections);
  /// Forgets all tracks and the time of the last scan. Names do not come again.
  void restart();
  /// Tracks that have enough detections.
  std::size_t count() const;

 private:
  struct Track;

  void end_lost(std::int64_t stamp);
  void begin(const tern_onboard::Sighting& detection);

  TrackerSettings settings_;
  std::vector<Track> tracks_;
  std::int64_t last_;
  std::uint64_t next_ = 1;
};

}  // namespace tern_tracker

#endif
