// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/detector.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host/flight/ray_length.hpp"
#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/things/surface_distance.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr std::int64_t kToldFor = 2000000000;           // ns: longer than a frame waits
constexpr std::uint64_t kDetectorStream = 0x7D1E5EEDu;  // apart from the other random numbers of a flight

/// Uniform in a ball.
Vec3 error_within(double radius, Noise& noise) {
  for (;;) {
    const Vec3 unit{noise.within(-1.0, 1.0), noise.within(-1.0, 1.0), noise.within(-1.0, 1.0)};
    if (length(unit) <= 1.0) return along({0.0, 0.0, 0.0}, radius, unit);
  }
}

Vec3 expected_place(const tern::Track& track, std::int64_t t) {
  return along(track.position, seconds_of(t - track.measured), track.velocity);
}

}  // namespace

Detector::Detector(const FlightWorld& world, const std::vector<ThingMotion>& things, std::int64_t begin,
                   std::uint32_t first_id)
    : world_(world),
      things_(things),
      begin_(begin),
      noise_(world.settings.seed ^ kDetectorStream),
      ids_(things.size()),
      clusters_(world.settings.cluster_class, world.boundary.lower.z),
      watch_(world.things, things) {
  std::iota(ids_.begin(), ids_.end(), first_id);
}

bool Detector::sees(const Vec3& eye, const Vec3& place) const {
  const double far = distance_between(eye, place);
  if (far > world_.settings.detection_range) return false;
  if (world_.settings.detection_occlusion == 0 || !(far > 0.0)) return true;
  const Vec3 ray = along({0.0, 0.0, 0.0}, 1.0 / far, along(place, -1.0, eye));
  FlightWorld open = {};
  open.blocks = world_.blocks;
  open.cylinders = world_.cylinders;
  constexpr double kEverywhere = 1e6;
  open.boundary = {{-kEverywhere, -kEverywhere, -kEverywhere}, {kEverywhere, kEverywhere, kEverywhere}};
  return ray_length(open, eye, ray) >= far;
}

Detector::Measurement Detector::measure(std::size_t thing, std::int64_t t, const Vec3& pose_error) {
  const FlightSettings& s = world_.settings;
  const Thing& what = world_.things[thing];
  const ThingState state = things_[thing].at(seconds(t));
  const ThingBounds& bounds = what.claimed.speed > 0.0 ? what.claimed : things_[thing].bounds();
  tern::Track track;
  track.id = ids_[thing];
  track.measured = t;
  track.position = along(along(state.position, 1.0, pose_error), 1.0, error_within(s.detection_error, noise_));
  track.velocity = along(state.velocity, 1.0, error_within(s.detection_speed_error, noise_));
  track.shape = what.shape;
  track.radius = what.radius;
  track.half = what.half;
  track.error = s.detection_error + s.pose_margin;
  track.error_speed = s.detection_speed_error;
  track.error_growth = s.thing_bounds * bounds.acceleration;
  track.reach = s.thing_bounds * bounds.speed;
  return {thing, track};
}

void Detector::swap_identities(std::vector<Measurement>& seen) {
  for (Measurement& one : seen) {
    if (!noise_.chance(world_.settings.detection_swaps)) continue;
    Measurement* nearest = nullptr;
    for (Measurement& other : seen) {
      if (&other == &one) continue;
      const double far = distance_between(other.track.position, one.track.position);
      if (nearest == nullptr || far < distance_between(nearest->track.position, one.track.position)) nearest = &other;
    }
    if (nearest == nullptr) return;
    std::swap(ids_[one.thing], ids_[nearest->thing]);
    std::swap(one.track.id, nearest->track.id);
  }
}

void Detector::take(std::int64_t t, const Vec3& place, const Vec3& estimate) {
  const FlightSettings& s = world_.settings;
  if (uses_clusters() || things_.empty() || static_cast<double>(taken_) > seconds(t) * s.detection_hz) return;
  ++taken_;
  const Vec3 pose_error = along(estimate, -1.0, place);
  Scan scan{t, estimate, {}};
  for (std::size_t k = 0; k < things_.size(); ++k) {
    if (!sees(place, things_[k].at(seconds(t)).position)) continue;
    const Measurement one = measure(k, t, pose_error);
    if (!noise_.chance(s.detection_misses)) scan.seen.push_back(one);
  }
  if (s.detection_swaps > 0.0) swap_identities(scan.seen);
  waiting_.push_back(std::move(scan));
}

template <typename Frame>
void Detector::see(const Frame& frame, const Vec3& eye, const tern::RollingMap& map) {
  const FlightSettings& s = world_.settings;
  if (!uses_clusters() || static_cast<double>(taken_) > seconds(frame.taken) * s.detection_hz) return;
  ++taken_;
  const std::vector<tern::Track> tracks = clusters_.see(frame, map);
  watch_.note(frame, s.sensor_range, tracks);
  Scan scan{frame.taken, eye, {}};
  for (const tern::Track& track : tracks) scan.seen.push_back({watch_.thing_of(track), track});
  waiting_.push_back(std::move(scan));
}

template void Detector::see(const DepthFrame&, const Vec3&, const tern::RollingMap&);
template void Detector::see(const LidarScan&, const Vec3&, const tern::RollingMap&);

void Detector::deliver(std::int64_t t, tern::Flight& flight, FlightTape& tape) {
  const std::int64_t latency = nanoseconds(world_.settings.detection_latency);
  for (; !waiting_.empty() && waiting_.front().taken + latency <= t; waiting_.pop_front()) {
    tell(waiting_.front(), t, flight, tape);
  }
}

void Detector::tell(const Scan& scan, std::int64_t t, tern::Flight& flight, FlightTape& tape) {
  const std::int64_t oldest = scan.taken - kToldFor;
  while (!told_.empty() && told_.front().measured < oldest) told_.pop_front();
  while (!forgotten_.empty() && forgotten_.front().when < oldest) forgotten_.pop_front();
  forget_lost(scan, flight, tape);
  std::vector<Measurement> order = scan.seen;
  std::stable_sort(order.begin(), order.end(), [&scan](const Measurement& a, const Measurement& b) {
    return distance_between(a.track.position, scan.from) < distance_between(b.track.position, scan.from);
  });
  for (const Measurement& one : order) {
    const bool is_new = known_.count(one.track.id) == 0;
    if (is_new && !make_room(scan, distance_between(one.track.position, scan.from), flight, tape)) {
      ++counts_.left_out;
      continue;
    }
    if (tape.update_track(flight, one.track) != tern::Status::kOk) continue;
    known_[one.track.id] = one;
    told_.push_back(one.track);
    if (uses_clusters()) watch_.note_told(one.track, t);
    ++counts_.measured;
    counts_.most_known = std::max(counts_.most_known, known_.size());
  }
}

void Detector::forget_lost(const Scan& scan, tern::Flight& flight, FlightTape& tape) {
  for (auto it = known_.begin(); it != known_.end();) {
    const tern::Track& track = it->second.track;
    const bool is_far =
        distance_between(expected_place(track, scan.taken), scan.from) > world_.settings.detection_range;
    const bool is_lost = is_far || (memory() > 0 && scan.taken - track.measured > memory());
    it = is_lost ? forget(it, scan.taken, flight, tape) : std::next(it);
  }
}

bool Detector::make_room(const Scan& scan, double far, tern::Flight& flight, FlightTape& tape) {
  if (known_.size() < std::size_t{tern::kMaxFlightTracks}) return true;
  const auto distance_of = [&scan](const auto& entry) {
    return distance_between(expected_place(entry.second.track, scan.taken), scan.from);
  };
  const auto farthest = std::max_element(known_.begin(), known_.end(),
                                         [&](const auto& a, const auto& b) { return distance_of(a) < distance_of(b); });
  if (distance_of(*farthest) <= far) return false;
  forget(farthest, scan.taken, flight, tape);
  return true;
}

Detector::Known::iterator Detector::forget(Known::iterator one, std::int64_t t, tern::Flight& flight,
                                           FlightTape& tape) {
  tape.forget_track(flight, one->first);
  forgotten_.push_back({t, one->second.track});
  return known_.erase(one);
}

bool Detector::explains(const Vec3& point, std::int64_t t, double room) const {
  constexpr double kLongest = 0.5;  // s between frame and measurement, and
  constexpr double kWidest = 1.0;   // m of error, beyond which tracks explain no hits
  return std::any_of(told_.begin(), told_.end(), [&](const tern::Track& track) {
    const double age = std::abs(seconds_of(t - track.measured));
    if (age > kLongest) return false;
    return growth_until(track, expected_place(track, t), point) <= std::min(error_after(track, age), kWidest) + room;
  });
}

bool Detector::meets(const Vec3& place, std::int64_t t) const {
  constexpr double kRounding = 1e-6;
  const FlightSettings& s = world_.settings;
  const double clearance = s.body_radius + s.pose_margin + s.tracking_margin + kRounding;
  const auto is_met = [&](const tern::Track& track) {
    const double age = seconds_of(t - track.measured);
    if (age < 0.0) return false;
    const bool reaches = track.reach == 0.0 ||
                         surface_distance(track, track.position, place) <= track.error + track.reach * age + clearance;
    return reaches && surface_distance(track, expected_place(track, t), place) <= error_after(track, age) + clearance;
  };
  // Plans that are being made keep clear of what was forgotten since.
  const auto was_met = [&](const Forgotten& one) { return is_met(one.track); };
  return std::any_of(told_.begin(), told_.end(), is_met) ||
         std::any_of(forgotten_.begin(), forgotten_.end(), was_met) ||
         std::any_of(known_.begin(), known_.end(), [&](const auto& entry) { return is_met(entry.second.track); });
}

const tern::Track* Detector::known(std::size_t thing) const {
  const tern::Track* latest = nullptr;
  for (const auto& [id, measurement] : known_) {
    if (measurement.thing != thing) continue;
    if (!uses_clusters()) return &measurement.track;
    // A thing that changed its identity is where its latest track says.
    if (latest == nullptr || measurement.track.measured > latest->measured) latest = &measurement.track;
  }
  return latest;
}

}  // namespace tern_host
