// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/tracker/README.md: a man walks through a room that the map has seen free; the camera's depths alone track him.
#include "tern_tracker/clusters.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "tern/tern.hpp"
#include "tern_tracker/changes.hpp"
#include "tern_tracker/detection.hpp"
#include "tern_tracker/tracker.hpp"

static std::vector<tern_onboard::Sighting> look(const tern::RollingMap& map, const tern::DepthView& view,
                                                const tern::Pose& pose, std::int64_t stamp,
                                                tern_tracker::Tracker& tracker) {
  static tern_tracker::Clusters clusters;  // 330,000 bytes
  clusters.begin({});
  tern_tracker::add_changes(map, view, pose, clusters);
  clusters.join();
  std::vector<tern_onboard::Sighting> detections;
  for (std::int32_t k = 0; k < clusters.size(); ++k) {
    detections.push_back(tern_tracker::detection_of(clusters[k], pose.position, tern::TrackClass::kPerson));
  }
  return tracker.scan(stamp, detections);
}

/// A wall 6 m ahead, and a man 3 m ahead where there is one: 0.6 m wide, `aside` to the right.
static std::vector<float> depths(const tern::DepthView& view, bool has_man, double aside) {
  std::vector<float> all;
  for (int v = 0; v < view.height; ++v) {
    for (int u = 0; u < view.width; ++u) {
      const bool is_man = has_man && std::abs(3.0 * (u - view.cx) / view.fx - aside) < 0.3;
      all.push_back(is_man ? 3.0f : 6.0f);
    }
  }
  return all;
}

int main() {
  const tern::MapSpec spec = tern::map_spec({-12.8, -6.4, 0.0}, 0.2, {128, 64, 16}, 0.35);
  std::vector<std::uint64_t> words(tern::map_words(spec));
  tern::RollingMap map;
  if (map.bind(spec, words.data(), words.size()) != tern::Status::kOk) return 1;
  const tern::Pose pose = {{0.0, 0.0, 1.5}, {0.5, -0.5, 0.5, -0.5}};
  tern::DepthView view{};
  view.width = view.stride = 160;
  view.height = 120;
  view.fx = view.fy = 80.0;
  view.cx = 79.5;
  view.cy = 59.5;
  view.scale = 1.0;
  view.min = 0.2;
  view.max = 10.0;
  tern_tracker::Tracker tracker;
  std::vector<tern_onboard::Sighting> told;
  for (int k = 0; k < 10; ++k) {
    const std::int64_t stamp = 100000000LL * k;
    const std::vector<float> image = depths(view, k > 0, 0.1 * k - 0.5);  // 1 m/s to the right, which is along -y
    view.z32 = image.data();
    told = look(map, view, pose, stamp, tracker);
    if (map.begin_frame(view, pose, stamp) != tern::Status::kRunning) return 1;
    while (map.step(1000) == tern::Status::kRunning) continue;
  }
  if (told.size() != 1) return 1;
  const tern::Vec3 &at = told[0].position, &v = told[0].velocity;
  return std::hypot(at.x - 3.4, at.y + 0.4) < 0.2 && std::hypot(v.x, v.y + 1.0) < 0.3 ? 0 : 1;
}
