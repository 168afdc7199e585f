// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/thing_watch.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/things/surface_distance.hpp"

namespace tern_host {
namespace {

constexpr double kMoving = 1e-3;                   // m/s
constexpr double kLeastWayToThing = 1e-3;          // m: nearer ones are looked at once a millimetre
constexpr double kShallow = 1e-6;                  // m: a contact that is less deep is none
constexpr std::int64_t kLeastTimeToThing = 20000;  // ns: a millimetre at 50 m/s

/// How long body and thing need at least for `way` between them, s.
double time_to_close(double way, double speed, double acceleration) {
  return (std::sqrt(speed * speed + 2.0 * acceleration * way) - speed) / acceleration;
}

/// How wide and how tall a shape is from its centre on, m.
struct Extent {
  double level, up;
};

template <typename Shaped>
Extent extent_of(const Shaped& shaped) {
  if (shaped.shape == tern::TrackShape::kBall) return {shaped.radius, shaped.radius};
  if (shaped.shape == tern::TrackShape::kCylinder) return {shaped.radius, shaped.half.z};
  return {std::hypot(shaped.half.x, shaped.half.y), shaped.half.z};
}

/// How far a thing must be moved to be in the shape of a track, m, or more. `off`: its centre from the track's.
double outside(const tern::Track& track, const Thing& thing, const tern::Vec3& off) {
  const Extent holds = extent_of(track), held = extent_of(thing);
  if (track.shape == tern::TrackShape::kBall) {
    const double far = thing.shape == tern::TrackShape::kBall
                           ? length(off) + thing.radius
                           : std::hypot(std::hypot(off.x, off.y) + held.level, std::abs(off.z) + held.up);
    return std::max(0.0, far - track.radius);
  }
  const double level = std::hypot(off.x, off.y) - (holds.level - held.level);
  const double up = std::abs(off.z) - (holds.up - held.up);
  return std::hypot(std::max(level, 0.0), std::max(up, 0.0));
}

}  // namespace

bool is_in_tube(const tern::Track& track, const Thing& thing, const tern::Vec3& place, std::int64_t t) {
  const double s = seconds_of(t - track.measured);
  if (s < 0.0) return false;
  constexpr double kRounding = 1e-9;
  const double moved = outside(track, thing, along(place, -1.0, track.position));
  const double off = outside(track, thing, along(place, -1.0, along(track.position, s, track.velocity)));
  const bool reaches = track.reach == 0.0 || moved <= track.error + track.reach * s + kRounding;
  return off <= error_after(track, s) + kRounding && reaches;
}

ThingWatch::ThingWatch(const std::vector<Thing>& things, const std::vector<ThingMotion>& motions)
    : things_(things),
      motions_(motions),
      due_(things.size(), 0),
      touches_(things.size(), false),
      proven_with_(things.size()) {}

void ThingWatch::note_commit(bool proven, const Detector& detector) {
  is_proven_ = proven;
  for (std::size_t k = 0; k < things_.size(); ++k) {
    const tern::Track* const track = detector.known(k);
    proven_with_[k] = track == nullptr ? std::nullopt : std::optional<tern::Track>(*track);
  }
}

std::int64_t ThingWatch::next(std::int64_t t, std::int64_t end) const {
  std::int64_t soonest = end;
  for (const std::int64_t due : due_) soonest = std::min(soonest, due);
  return std::max(soonest, t);
}

void ThingWatch::look(std::int64_t t, const MovingBody& body, double command_speed) {
  for (std::size_t k = 0; k < things_.size(); ++k) {
    if (due_[k] > t) continue;
    const tern::Vec3 place = motions_[k].at(seconds_of(t)).position;
    const double gap = surface_distance(things_[k], place, body.position) - body.radius;
    const bool touches = gap < -kShallow;
    if (touches && !touches_[k]) begin_contact(k, t, place, command_speed);
    touches_[k] = touches;
    const double way = std::max(kLeastWayToThing, std::abs(gap));
    const double time = time_to_close(way, body.speed + motions_[k].bounds().speed, body.acceleration);
    due_[k] = t + std::max(kLeastTimeToThing, static_cast<std::int64_t>(1e9 * time));
  }
}

void ThingWatch::begin_contact(std::size_t thing, std::int64_t t, const tern::Vec3& place, double command_speed) {
  const std::optional<tern::Track>& track = proven_with_[thing];
  const bool in_tube = is_proven_ && track.has_value() && is_in_tube(*track, things_[thing], place, t);
  contacts_.push_back({thing, seconds_of(t), command_speed, command_speed > kMoving, in_tube});
}

const ThingContact* ThingWatch::in_motion() const {
  const auto found =
      std::find_if(contacts_.begin(), contacts_.end(), [](const ThingContact& contact) { return contact.in_motion; });
  return found == contacts_.end() ? nullptr : &*found;
}

}  // namespace tern_host
