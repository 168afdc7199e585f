// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_tracker/cluster_detector.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "tern_onboard/map_spec.hpp"
#include "tern_onboard/parameters.hpp"
#include "tern_tracker/changes.hpp"
#include "tern_tracker/detection.hpp"

namespace tern_tracker {

using tern_onboard::Seen;

Seen ClusterDetector::see(int sensor, const tern::RollingMap& map, const tern::DepthView& view, const tern::Pose& eye,
                          std::int64_t stamp) {
  clusters_->begin({});
  return track(sensor, add_changes(map, view, eye, *clusters_, ground_), eye.position, stamp);
}

Seen ClusterDetector::see(int sensor, const tern::RollingMap& map, const tern::Beams& beams, const tern::Vec3& origin,
                          std::int64_t stamp) {
  clusters_->begin({});
  return track(sensor, add_changes(map, beams, origin, *clusters_, ground_), origin, stamp);
}

Seen ClusterDetector::track(int sensor, ClusterStatus added, const tern::Vec3& eye, std::int64_t stamp) {
  const ClusterStatus joined = clusters_->join();
  DetectionSettings settings;
  settings.ground = ground_;
  std::vector<tern_onboard::Sighting> detections;
  for (std::int32_t k = 0; k < clusters_->size(); ++k) {
    detections.push_back(detection_of((*clusters_)[k], eye, kind_, settings));
  }
  return {trackers_[sensor].scan(stamp, detections), added == ClusterStatus::kOk && joined == ClusterStatus::kOk};
}

void ClusterDetector::restart() {
  for (auto& [sensor, tracker] : trackers_) tracker.restart();
}

std::unique_ptr<tern_onboard::Detector> detector_of(const tern_onboard::Settings& settings) {
  const std::vector<std::string>& words = tern_onboard::class_words();
  const auto word = std::find(words.begin(), words.end(), settings.things.clusters);
  if (word == words.end()) return nullptr;
  const double ground =
      settings.fly.ground > tern_onboard::kNoGround ? settings.fly.ground : -std::numeric_limits<double>::infinity();
  return std::make_unique<ClusterDetector>(static_cast<tern::TrackClass>(word - words.begin()), ground);
}

}  // namespace tern_tracker
