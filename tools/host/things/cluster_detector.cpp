// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/cluster_detector.hpp"

#include "tern_tracker/changes.hpp"
#include "tern_tracker/detection.hpp"

namespace tern_host {
namespace {

constexpr double kSigmas = 4.0;  // as tern::onboard's thing_sigmas

}  // namespace

std::vector<tern::Track> ClusterDetector::see(const DepthFrame& frame, const tern::RollingMap& map) {
  clusters_->begin({});
  tern_tracker::add_changes(map, frame.view, frame.pose, *clusters_);
  return track(frame.taken, frame.pose.position);
}

std::vector<tern::Track> ClusterDetector::see(const LidarScan& scan, const tern::RollingMap& map) {
  clusters_->begin({});
  tern_tracker::add_changes(map, scan.beams(), scan.origin, *clusters_);
  return track(scan.taken, scan.origin);
}

/// Full capacities leave out what is told last: the flight then knows that much less, as with any detector.
std::vector<tern::Track> ClusterDetector::track(std::int64_t taken, const tern::Vec3& eye) {
  clusters_->join();
  tern_tracker::DetectionSettings settings;
  settings.ground = ground_;
  std::vector<tern_onboard::Sighting> detections;
  for (std::int32_t k = 0; k < clusters_->size(); ++k) {
    detections.push_back(tern_tracker::detection_of((*clusters_)[k], eye, kind_, settings));
  }
  std::vector<tern::Track> tracks;
  for (const tern_onboard::Sighting& told : tracker_.scan(taken, detections)) {
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
