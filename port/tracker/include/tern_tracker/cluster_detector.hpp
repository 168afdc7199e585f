// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tracks of what cameras and lidars see move, for vehicles without a detector: changes, clusters and a tracker in one.
#ifndef TERN_TRACKER_CLUSTER_DETECTOR_HPP
#define TERN_TRACKER_CLUSTER_DETECTOR_HPP

#include <cstdint>
#include <map>
#include <memory>

#include "tern_onboard/detector.hpp"
#include "tern_onboard/settings.hpp"
#include "tern_tracker/clusters.hpp"
#include "tern_tracker/tracker.hpp"

namespace tern_tracker {

/// Not thread-safe. Each sensor has a tracker of its own, so what two of them see has two tracks.
class ClusterDetector : public tern_onboard::Detector {
 public:
  /// All that moves is taken to be of this class. `ground`: as DetectionSettings.
  ClusterDetector(tern::TrackClass kind, double ground) : kind_(kind), ground_(ground), clusters_(new Clusters) {}

  tern_onboard::Seen see(int sensor, const tern::RollingMap& map, const tern::DepthView& view, const tern::Pose& eye,
                         std::int64_t stamp) override;
  tern_onboard::Seen see(int sensor, const tern::RollingMap& map, const tern::Beams& beams, const tern::Vec3& origin,
                         std::int64_t stamp) override;
  void restart() override;

 private:
  tern_onboard::Seen track(int sensor, ClusterStatus added, const tern::Vec3& eye, std::int64_t stamp);

  tern::TrackClass kind_;
  double ground_;
  std::unique_ptr<Clusters> clusters_;
  std::map<int, Tracker> trackers_;  // of each sensor
};

/// What Onboard needs for the parameter `clusters`; null for none.
std::unique_ptr<tern_onboard::Detector> detector_of(const tern_onboard::Settings& settings);

}  // namespace tern_tracker

#endif
