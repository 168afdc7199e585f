// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tracks of what a camera or a lidar sees move: for flights that have no detector.
#ifndef TERN_HOST_THINGS_CLUSTER_DETECTOR_HPP
#define TERN_HOST_THINGS_CLUSTER_DETECTOR_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/flight/depth_camera.hpp"
#include "host/flight/lidar.hpp"
#include "tern/map.hpp"
#include "tern_tracker/cluster_detector.hpp"

namespace tern_host {

class ClusterDetector {
 public:
  /// All that moves is taken to be of this class; people and vehicles stand on the ground, m.
  ClusterDetector(tern::TrackClass kind, double ground) : detector_(kind, ground) {}

  /// The tracks that were seen in a frame or scan, which has entered the map, or is about to.
  std::vector<tern::Track> see(const DepthFrame& frame, const tern::RollingMap& map);
  std::vector<tern::Track> see(const LidarScan& scan, const tern::RollingMap& map);

 private:
  std::vector<tern::Track> tracks_of(const tern_onboard::Seen& seen);

  tern_tracker::ClusterDetector detector_;
  std::map<std::string, tern::Track> last_;  ///< of each track
};

}  // namespace tern_host

#endif
