// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/tracking_watch.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/sensor_mount.hpp"
#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/things/surface_distance.hpp"
#include "host/things/thing_watch.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kNear = 1.0;     // m, of a track and its thing
constexpr double kOnThing = 0.2;  // m, of a hit
constexpr int kLeastHits = 8;
constexpr double kHeldFor = 0.5;    // s
constexpr double kOutOfView = 1.0;  // s

std::vector<Vec3> hits_of(const DepthFrame& frame, double range) {
  std::vector<Vec3> hits;
  for (int v = 0; v < frame.view.height; ++v) {
    for (int u = 0; u < frame.view.width; ++u) {
      const double z = static_cast<double>(frame.depths[static_cast<std::size_t>(v * frame.view.width + u)]);
      if (!(z > 0.0 && z <= range)) continue;
      const Vec3 ray{(u - frame.view.cx) / frame.view.fx, (v - frame.view.cy) / frame.view.fy, 1.0};
      hits.push_back(along(frame.pose.position, z, turned(frame.pose, ray)));
    }
  }
  return hits;
}

std::vector<Vec3> hits_of(const LidarScan& scan, double range) {
  std::vector<Vec3> hits;
  for (std::size_t k = 0; k < scan.ranges.size(); ++k) {
    const double r = static_cast<double>(scan.ranges[k]);
    if (r > 0.0 && r <= range) hits.push_back(scan.point(k, r));
  }
  return hits;
}

}  // namespace

std::size_t TrackingWatch::thing_of(const tern::Track& track) const {
  std::size_t nearest = kNoThing;
  double least = kNear;
  for (std::size_t k = 0; k < things_.size(); ++k) {
    const Vec3 place = motions_[k].at(seconds_of(track.measured)).position;
    const double far = surface_distance(things_[k], place, track.position);
    if (far > least) continue;
    least = far;
    nearest = k;
  }
  return nearest;
}

void TrackingWatch::note_view(std::size_t thing, double now) {
  View& view = views_[thing];
  if (now - view.last > kOutOfView) {
    view.entered = now;
    view.is_born = false;
    ++figures_.entries;
  }
  view.last = now;
  ++figures_.in_view;
  if (now - view.tracked > kHeldFor) {
    ++figures_.missed;
    return;
  }
  if (view.is_born) return;
  view.is_born = true;
  ++figures_.births;
  figures_.late += now - view.entered;
  figures_.latest = std::max(figures_.latest, now - view.entered);
}

template <typename Frame>
void TrackingWatch::note(const Frame& frame, double range, const std::vector<tern::Track>& tracks) {
  ++figures_.scans;
  const double now = seconds_of(frame.taken);
  for (const tern::Track& track : tracks) {
    const std::size_t thing = thing_of(track);
    (thing == kNoThing ? unreal_ : real_).insert(track.id);
    if (thing != kNoThing) views_[thing].tracked = now;
  }
  const std::vector<Vec3> hits = hits_of(frame, range);
  for (std::size_t k = 0; k < things_.size(); ++k) {
    const Vec3 place = motions_[k].at(now).position;
    const auto is_on = [&](const Vec3& hit) { return surface_distance(things_[k], place, hit) <= kOnThing; };
    if (std::count_if(hits.begin(), hits.end(), is_on) >= kLeastHits) note_view(k, now);
  }
}

template void TrackingWatch::note(const DepthFrame&, double, const std::vector<tern::Track>&);
template void TrackingWatch::note(const LidarScan&, double, const std::vector<tern::Track>&);

void TrackingWatch::note_told(const tern::Track& track, std::int64_t t) {
  ++figures_.told;
  const std::size_t thing = thing_of(track);
  if (thing == kNoThing) {
    ++figures_.of_nothing;
    return;
  }
  if (!is_in_tube(track, things_[thing], motions_[thing].at(seconds_of(t)).position, t)) ++figures_.outside;
}

TrackingFigures TrackingWatch::figures() const {
  TrackingFigures figures = figures_;
  figures.false_tracks = static_cast<std::uint64_t>(
      std::count_if(unreal_.begin(), unreal_.end(), [this](std::uint32_t id) { return real_.count(id) == 0; }));
  return figures;
}

}  // namespace tern_host
