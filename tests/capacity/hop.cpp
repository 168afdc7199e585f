// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capacity/hop.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/math.hpp"

namespace tern_capacity {
namespace {

using tern::Status;
using tern::Vec3;

constexpr double kRadius = 0.4;
constexpr double kSpeed = 3.0;
constexpr double kAcceleration = 6.0;
constexpr double kSight = 4.0;
constexpr int kTicks = 900;
constexpr int kSurpriseTick = 140;
constexpr int kTrackTick = 5;
constexpr Vec3 kStart{-2.75, 0.25, 0.25};
constexpr Vec3 kGoal{2.75, 0.25, 0.25};

tern::MapSpec map_spec() {
  tern::MapSpec spec = tern::map_spec({-8.0, -4.0, -2.0}, 0.5, {32, 16, 8}, kRadius);
  spec.pixels = 1024;
  return spec;
}

bool ended(const tern::FlightReport& report) {
  return report.mode == tern::FlightMode::kRest && report.reason != tern::FlightReason::kNone;
}

std::uint64_t hash_after(std::uint64_t hash, const tern::Sample& sample) {
  std::uint64_t words[6];
  std::memcpy(words, &sample, sizeof words);  // position and velocity
  for (const std::uint64_t word : words) hash = (hash ^ word) * 0x100000001B3u;
  return hash;
}

}  // namespace

Hop::Hop(Surprise surprise)
    : surprise_(surprise),
      map_(map_spec()),
      memory_(new tern::Workspace),
      planner_(memory_.get(), sizeof *memory_),
      spec_(tern::flight_spec({{kSpeed, kSpeed, 2.0}, {kAcceleration, kAcceleration, kAcceleration}})) {
  look_around(kStart);
  add({{0.1, -1.2, -2.0}, {0.4, 0.9, 2.0}});
  spec_.work_per_tick = 1000;
  spec_.plan_work = 8000;
  spec_.near = 0.5;
  spec_.horizon = 3.0;
  words_.resize(tern::flight_words(map_spec().dims));
  status_ = flight_.start(spec_, map_.map, planner_, words_.data(), words_.size(), kStart, 0);
}

std::string Hop::fly(bool may_touch) {
  if (status_ != Status::kOk || flight_.set_goal(kGoal) != Status::kOk) return "it does not begin";
  tern::FlightReport report{};
  tern::Sample last = flight_.command(0).sample;
  for (int k = 0; k < kTicks && !(k > kSurpriseTick && ended(report)); ++k) {
    if (k == kSurpriseTick) be_surprised();
    if (k % 10 == 0) look_around(last.position);
    if (k == kTrackTick) note_thing();
    const std::int64_t t = k * spec_.tick;
    if (flight_.tick(t, report) != Status::kOk) return "a tick is refused";
    if (report.work > spec_.work_per_tick) return "a tick works too much";
    const tern::Sample now = flight_.command(t + spec_.tick).sample;
    const bool is_said = report.mode == tern::FlightMode::kThreat || report.blocked_by == tern::BlockedBy::kObstacle;
    const bool is_excused = may_touch && is_said;
    const std::string wrong = is_excused ? wrong_with(last, now) : wrong_place(now) + wrong_with(last, now);
    if (!wrong.empty()) return wrong + " at tick " + std::to_string(k);
    hash_ = hash_after(hash_, now);
    last = now;
  }
  reason_ = report.reason;
  const tern::Sample end = flight_.command((kTicks + 1000) * spec_.tick).sample;
  return tern::length(end.velocity) > 0.0 ? "it does not end at rest" : "";
}

void Hop::look_around(const Vec3& at) {
  map_.map.assume_free(at, kSight);
}

void Hop::add(const tern::Box& box) {
  map_.map.mark_box(box);
  boxes_.push_back(box);
}

/// A ball far away that stays there.
void Hop::note_thing() {
  const tern::TrackPiece still{1.0, {}};
  tern::Track track;
  track.position = {100.0, 0.0, 0.0};
  track.radius = 0.3;
  flight_.update_track(track);
  track.pieces = &still;
  track.piece_count = 1;
  flight_.update_track(track);
}

void Hop::be_surprised() {
  if (surprise_ == Surprise::kFar) add({{2.0, 1.1, -2.0}, {2.2, 1.4, 2.0}});
  if (surprise_ == Surprise::kNear) add({{0.1, 0.8, -2.0}, {0.3, 1.05, 2.0}});
}

double Hop::clearance(const Vec3& p) const {
  double least = 1e9;
  for (const tern::Box& box : boxes_) {
    Vec3 gap{};
    for (int a = 0; a < 3; ++a) {
      const double below = tern::axis(box.lower, a) - tern::axis(p, a);
      tern::axis(gap, a) = std::max({0.0, below, tern::axis(p, a) - tern::axis(box.upper, a)});
    }
    least = std::min(least, tern::length(gap));
  }
  return least;
}

std::string Hop::wrong_place(const tern::Sample& now) const {
  return clearance(now.position) < kRadius - 1e-6 ? "too near to an obstacle" : "";
}

std::string Hop::wrong_with(const tern::Sample& last, const tern::Sample& now) const {
  const double step = 1e-9 * static_cast<double>(spec_.tick);
  for (int a = 0; a < 3; ++a) {
    if (std::fabs(tern::axis(now.velocity, a)) > kSpeed * (1.0 + 1e-6)) return "too fast";
    const double way = tern::axis(now.position, a) - tern::axis(last.position, a);
    if (std::fabs(way) > kSpeed * step * (1.0 + 1e-6)) return "a jump of the position";
    const double change = tern::axis(now.velocity, a) - tern::axis(last.velocity, a);
    if (std::fabs(change) > kAcceleration * step * (1.0 + 1e-6)) return "a jump of the velocity";
  }
  return "";
}

}  // namespace tern_capacity
