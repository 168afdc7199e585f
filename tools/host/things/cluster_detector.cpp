// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/cluster_detector.hpp"

namespace tern_host {
namespace {

constexpr double kSigmas = 4.0;  // as tern::onboard's thing_sigmas

}  // namespace

std::vector<tern::Track> ClusterDetector::see(const DepthFrame& frame, const tern::RollingMap& map) {
  return tracks_of(detector_.see(0, map, frame.view, frame.pose, frame.taken));
}

std::vector<tern::Track> ClusterDetector::see(const LidarScan& scan, const tern::RollingMap& map) {
  return tracks_of(detector_.see(0, map, scan.beams(), scan.origin, scan.taken));
}

/// Full capacities leave out what is told last: the flight then knows that much less, as with any detector.
std::vector<tern::Track> ClusterDetector::tracks_of(const tern_onboard::Seen& seen) {
  std::vector<tern::Track> tracks;
  for (const tern_onboard::Sighting& told : seen.things) {
    tern::Track track = tern_onboard::track_of(told, kSigmas);
    const auto [known, is_new] = last_.try_emplace(told.name, track);
    track.id = is_new ? static_cast<std::uint32_t>(last_.size()) : known->second.id;
    if (!is_new) tern_onboard::keep_bounds(known->second, track);
    known->second = track;
    tracks.push_back(track);
  }
  return tracks;
}

}  // namespace tern_host
