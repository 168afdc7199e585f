// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_faults.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kPillarRadius = 0.3;    // metres, of what appears ahead
constexpr double kLeastSpeed = 0.5;      // m/s: slower, nothing is ahead
constexpr std::int64_t kStep = 2000000;  // nanoseconds along what is commanded
constexpr std::int64_t kMostAhead = 60000000000;

}  // namespace

FlightFaults::FlightFaults(FlightWorld& truth)
    : truth_(truth),
      still_(truth),
      tick_noise_(truth.settings.seed * 7919 + 1),
      goal_noise_(truth.settings.seed * 7919 + 2),
      pillar_is_due_(truth.settings.appear_ahead.distance > 0.0),
      due_(truth.appearing) {}

/// Runs of skipped ticks are 1 to `longest` long, and begin as often as makes their share. The tick behind a run is
/// done, and so is the first one.
bool FlightFaults::skips_tick() {
  const TickSkips& skips = truth_.settings.tick_skip;
  const double mean = 0.5 * (1.0 + skips.longest);
  const bool begins = did_tick_ && skips.share > 0.0 && tick_noise_.chance(skips.share / (mean * (1.0 - skips.share)));
  if (begins) skips_left_ = 1 + tick_noise_.below(skips.longest);
  did_tick_ = skips_left_ == 0;
  if (did_tick_) return false;
  --skips_left_;
  return true;
}

bool FlightFaults::moves_goal(double t, Vec3& goal) {
  const GoalJitter& jitter = truth_.settings.goal_jitter;
  const bool moves = jitter.size > 0.0 && t < jitter.until;
  if (!moves && !goal_is_off_) return false;
  goal = truth_.goal;
  goal_is_off_ = moves;
  if (moves) {
    goal.x += goal_noise_.within(-jitter.size, jitter.size);
    goal.y += goal_noise_.within(-jitter.size, jitter.size);
  }
  return true;
}

void FlightFaults::add(const Appearance& appearance) {
  if (appearance.is_block) {
    truth_.blocks.push_back(appearance.block);
  } else {
    truth_.cylinders.push_back(appearance.cylinder);
  }
  appeared_.push_back(appearance);
}

bool FlightFaults::appear(std::int64_t t, const Commands& commands) {
  const double seconds = seconds_of(t);
  const std::size_t before = appeared_.size();
  for (auto due = due_.begin(); due != due_.end();) {
    if (due->time > seconds) {
      ++due;
      continue;
    }
    add({seconds, due->is_block, due->block, due->cylinder});
    due = due_.erase(due);
  }
  Cylinder pillar{};
  if (pillar_is_due_ && seconds >= truth_.settings.appear_ahead.time && pillar_ahead(t, commands, pillar)) {
    pillar_is_due_ = false;
    add({seconds, false, {}, pillar});
  }
  return appeared_.size() > before;
}

/// From floor to ceiling, with its axis on what is commanded, or straight behind its end.
bool FlightFaults::pillar_ahead(std::int64_t t, const Commands& commands, Cylinder& pillar) const {
  const tern::Sample now = commands(t);
  if (length(now.velocity) < kLeastSpeed) return false;
  double left = truth_.settings.appear_ahead.distance + kPillarRadius;
  Vec3 at = now.position;
  Vec3 along = now.velocity;
  for (std::int64_t ahead = kStep; left > 0.0 && ahead < kMostAhead; ahead += kStep) {
    const tern::Sample next = commands(t + ahead);
    const Vec3 way{next.position.x - at.x, next.position.y - at.y, next.position.z - at.z};
    if (!(length(way) > 0.0)) break;
    left -= length(way);
    along = way;
    at = next.position;
  }
  const double flat = std::max(1e-9, std::hypot(along.x, along.y));
  const double beyond = std::max(0.0, left) / flat;
  pillar = {at.x + beyond * along.x, at.y + beyond * along.y, truth_.boundary.lower.z, truth_.boundary.upper.z,
            kPillarRadius};
  return true;
}

}  // namespace tern_host
